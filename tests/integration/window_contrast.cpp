// What a person can read: the contrast of every label against its ground, measured in the pixels of the window.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "tests/support/ui_state.h"
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

}  // namespace

TEST_CASE("every label that can be used has a contrast of at least 4.5 to 1 in every theme") {
  const workbench::WorkbenchState state = testing::made_state_with_model();
  for (const ThemeKind theme : kThemeKinds) {
    auto window = OsmesaWindow::create({2400, 1500});
    REQUIRE(window);
    Settings settings;
    settings.scale = kScale;
    settings.theme = theme;
    const auto session = Session::create(**window, settings).value();
    Driver driver(*session, [&]() -> Status {
      (*window)->poll(0.0);
      TROCAR_ASSIGN_OR_RETURN([[maybe_unused]] const ShellResult result, session->frame(state));
      return {};
    });
    int labels = 0;
    for (const char* keys : {"Ctrl+1", "Ctrl+2", "Ctrl+3", "Ctrl+4"}) {
      REQUIRE(driver.key(keys));
      REQUIRE(driver.frames(4));
      const Image image = session->window().capture().value();
      for (const Item& item : session->items().items()) {
        if (!is_label(item)) continue;
        ++labels;
        CAPTURE(name_of(theme));
        CAPTURE(item.path);
        CHECK(contrast_within(image, item.rect) >= kLeastContrast);
      }
    }
    CHECK(labels > 150);
  }
}
