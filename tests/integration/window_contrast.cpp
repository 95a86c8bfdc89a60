// What a person can read: the contrast of every label against its ground, measured in the pixels of the window.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "tests/support/ui_take.h"
#include "ui/driver/driver.h"
#include "ui/session.h"
#include "ui/window/osmesa_window.h"

using namespace trocar;
using namespace trocar::ui;

namespace {

// Strokes are two pixels wide at 200 %, so that some pixel of each label has its full colour.
constexpr float kScale = 2.0F;
constexpr double kLeastContrast = 4.5;  // WCAG 2.1, success criterion 1.4.3.

Rgba pixel(const Image& image, int x, int y) {
  const auto at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], 255};
}

/// The largest contrast of any pixel within the rectangle against its commonest colour.
double contrast_within(const Image& image, const Rect& rect) {
  const int x0 = std::max(static_cast<int>(std::ceil(rect.x0)) + 1, 0);
  const int y0 = std::max(static_cast<int>(std::ceil(rect.y0)) + 1, 0);
  const int x1 = std::min(static_cast<int>(rect.x1) - 1, image.width);
  const int y1 = std::min(static_cast<int>(rect.y1) - 1, image.height);
  std::map<std::uint32_t, int> seen;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const Rgba p = pixel(image, x, y);
      ++seen[static_cast<std::uint32_t>(p.r) << 16U | static_cast<std::uint32_t>(p.g) << 8U | p.b];
    }
  }
  if (seen.empty()) return 0.0;
  const auto colour_of = [](std::uint32_t key) {
    return Rgba{static_cast<std::uint8_t>(key >> 16U), static_cast<std::uint8_t>(key >> 8U),
                static_cast<std::uint8_t>(key), 255};
  };
  const auto commonest =
      std::max_element(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const Rgba ground = colour_of(commonest->first);
  double best = 1.0;
  for (const auto& [key, times] : seen) best = std::max(best, contrast(ground, colour_of(key)));
  return best;
}

bool is_label(const Item& item) {
  for (const char* role : {"canvas", "splitter", "progress", "slider", "checkbox"}) {
    if (item.role == role) return false;
  }
  const bool whole = item.rect.x0 >= item.clip.x0 && item.rect.y0 >= item.clip.y0 && item.rect.y1 <= item.clip.y1;
  return item.enabled && whole && item.reachable() && !(item.role == "field" && item.value.empty());
}

/// A window of 2400 by 1500 pixels at 200 % on a state.
struct Glass {
  Glass(workbench::WorkbenchState shown, ThemeKind theme) : state(std::move(shown)) {
    window = std::move(OsmesaWindow::create({2400, 1500}).value());
    Settings settings;
    settings.scale = kScale;
    settings.theme = theme;
    session = Session::create(*window, settings).value();
    driver.emplace(*session, [this]() -> Status {
      window->poll(0.0);
      TROCAR_ASSIGN_OR_RETURN([[maybe_unused]] const ShellResult result, session->frame(state));
      return {};
    });
    REQUIRE(driver->frames(4));
  }

  /// Of the items that are at or below `within` ("": all); returns how many.
  int check(std::string_view within) {
    REQUIRE(driver->frames(4));
    const Image image = session->window().capture().value();
    int labels = 0;
    for (const Item& item : session->items().items()) {
      if (!is_label(item) || !item.path.starts_with(within)) continue;
      ++labels;
      CAPTURE(item.path);
      CHECK(contrast_within(image, item.rect) >= kLeastContrast);
    }
    return labels;
  }

  workbench::WorkbenchState state;
  std::unique_ptr<OsmesaWindow> window;
  std::unique_ptr<Session> session;
  std::optional<Driver> driver;
};

}  // namespace

TEST_CASE("every label that can be used has a contrast of at least 4.5 to 1 in every theme") {
  for (const ThemeKind theme : kThemeKinds) {
    CAPTURE(name_of(theme));
    Glass glass(testing::made_state_with_model(), theme);
    int labels = 0;
    for (const char* keys : {"Ctrl+1", "Ctrl+2", "Ctrl+3", "Ctrl+4"}) {
      CAPTURE(keys);
      REQUIRE(glass.driver->key(keys));
      labels += glass.check("");
    }
    CHECK(labels > 150);
  }
}

TEST_CASE("so has every label of forms, palette, help and the shortcut sheet") {
  struct Opened {
    const char* keys;
    const char* within;
    int least;
  };
  for (const ThemeKind theme : kThemeKinds) {
    CAPTURE(name_of(theme));
    for (const Opened& form : {Opened{"Shift+R", "Record/", 10}, Opened{"Ctrl+P", "Palette/", 5},
                               Opened{"Shift+/", "Keyboard shortcuts/", 20}, Opened{"Ctrl+O", "Open project/", 3},
                               Opened{"Ctrl+I", "Import/", 3}, Opened{"Ctrl+E", "Export video/", 5},
                               Opened{"Ctrl+Alt+E", "Export demonstrations/", 4}}) {
      CAPTURE(form.keys);
      Glass glass(testing::made_state_with_model(), theme);
      REQUIRE(glass.driver->key(form.keys));
      CHECK(glass.check(form.within) >= form.least);
    }
  }
}

TEST_CASE("so has every label while a take is counted in, recorded and judged, and while an edit is made") {
  for (const ThemeKind theme : kThemeKinds) {
    CAPTURE(name_of(theme));
    for (const auto& state :
         {testing::take_state(trial::Phase::kCountdown), testing::take_state(), testing::verdict_state()}) {
      Glass glass(state, theme);
      REQUIRE(glass.driver->key("Ctrl+2"));
      CHECK(glass.check("") > 20);
    }
    Glass glass(testing::made_state(), theme);
    REQUIRE(glass.driver->key("Ctrl+2"));
    REQUIRE(glass.driver->frames(3));
    REQUIRE(glass.driver->click("Tabs/Edits"));
    REQUIRE(glass.driver->click("Edits/Add edit…"));
    CHECK(glass.check("Edits/") > 5);
  }
}
