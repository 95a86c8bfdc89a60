#include "ui/panels/rollout_starts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/learning/start_file.h"
#include "ui/format.h"
#include "ui/panels/rollout_parts.h"

namespace trocar::ui {
namespace {

const std::vector<std::string>& kind_names() {
  static const std::vector<std::string> kNames{"Around the start", "All cells",       "Box",       "Face",   "Sphere",
                                               "Gaussian",         "Latin hypercube", "From file", "Painted"};
  return kNames;
}
constexpr std::array<std::string_view, 9> kBeginnings{
    "around:", "all", "box:", "face:", "sphere:", "gaussian:", "latin:", "file:", "cells:"};
const std::vector<std::string>& face_names() {
  static const std::vector<std::string> kNames{"x low", "x high", "y low", "y high", "z low", "z high (top)"};
  return kNames;
}
constexpr std::array<std::string_view, 6> kFaces{"x0", "x1", "y0", "y1", "z0", "z1"};

/// The whole numbers of a text, whatever is between them.
std::vector<std::int64_t> numbers_in(std::string_view text) {
  std::vector<std::int64_t> numbers;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] < '0' || text[i] > '9') continue;
    std::int64_t value = 0;
    for (; i < text.size() && text[i] >= '0' && text[i] <= '9'; ++i) {
      value = std::min<std::int64_t>(10 * value + (text[i] - '0'), 1'000'000'000);
    }
    numbers.push_back(value);
  }
  return numbers;
}

}  // namespace

void RolloutStarts::take_over(const WorkbenchState& state) {
  const std::string& starts = state.rollouts.starts;
  if (starts == shown_) return;
  shown_ = starts;
  for (std::size_t i = 0; i < kBeginnings.size(); ++i) {
    if (starts.starts_with(kBeginnings[i])) kind_ = static_cast<int>(i);
  }
  const std::vector<std::int64_t> numbers = numbers_in(starts);
  const auto kind = static_cast<Kind>(kind_);
  if (kind == Kind::kAround && numbers.size() == 1) around_ = static_cast<int>(numbers[0]);
  if (kind == Kind::kBox && numbers.size() == 6) std::copy(numbers.begin(), numbers.end(), box_.begin());
  if (kind == Kind::kSphere && numbers.size() == 4) std::copy(numbers.begin(), numbers.end(), sphere_.begin());
  if (kind == Kind::kFile) file_ = starts.substr(learning::kStartFile.size());
  if (kind == Kind::kFace) {
    const auto found = std::find(kFaces.begin(), kFaces.end(), std::string_view(starts).substr(5));
    if (found != kFaces.end()) face_ = static_cast<int>(found - kFaces.begin());
  }
  if (kind == Kind::kGaussian && numbers.size() == 3) {
    sigma_mm_ = numbers[0];
    draws_ = numbers[1];
    seed_ = numbers[2];
  }
  if (kind == Kind::kLatin && (numbers.size() == 2 || numbers.size() == 3)) {
    draws_ = numbers[0];
    seed_ = numbers[1];
    near_ = numbers.size() == 3 ? numbers[2] : 0;
  }
}

std::string RolloutStarts::text(int most) const {
  const auto between = [](std::int64_t a, std::int64_t b) {
    return fmt::format("{}-{}", std::min(a, b), std::max(a, b));
  };
  switch (static_cast<Kind>(kind_)) {
    case Kind::kAround:
      return fmt::format("around:{}", std::clamp(around_, 0, most));
    case Kind::kAll:
      return "all";
    case Kind::kBox:
      return fmt::format("box:{},{},{}", between(box_[0], box_[1]), between(box_[2], box_[3]),
                         between(box_[4], box_[5]));
    case Kind::kFace:
      return fmt::format("face:{}", kFaces[static_cast<std::size_t>(face_)]);
    case Kind::kSphere:
      return fmt::format("sphere:{},{},{},{}", sphere_[0], sphere_[1], sphere_[2], sphere_[3]);
    case Kind::kGaussian:
      return fmt::format("gaussian:{},{},{}", sigma_mm_, draws_, seed_);
    case Kind::kLatin:
      return near_ == 0 ? fmt::format("latin:{},{}", draws_, seed_)
                        : fmt::format("latin:{},{},{}", draws_, seed_, std::min<std::int64_t>(near_, most));
    case Kind::kFile:
      return fmt::format("{}{}", learning::kStartFile, file_);
    case Kind::kPainted:
      break;
  }
  return shown_;
}

bool RolloutStarts::draw_numbers(Ui& ui, int most) {
  bool changed = false;
  const auto row = [&](std::string_view label, std::span<std::int64_t> values, std::span<const std::string_view> names,
                       std::int64_t low, std::int64_t high) {
    form_label(ui, label);
    const float gap = ui.px(4);
    const float width = (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(values.size() - 1)) /
                        static_cast<float>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) ImGui::SameLine(0.0F, gap);
      changed |= number_field(ui, names[i], values[i], low, high, {.help = names[i], .width = width});
    }
  };
  constexpr std::array<std::string_view, 2> kX{"From x", "To x"};
  constexpr std::array<std::string_view, 2> kY{"From y", "To y"};
  constexpr std::array<std::string_view, 2> kZ{"From z", "To z"};
  constexpr std::array<std::string_view, 3> kMiddle{"Middle x", "Middle y", "Middle z"};
  switch (static_cast<Kind>(kind_)) {
    case Kind::kAround:
      form_label(ui, "Start within");
      changed |= slider_int(ui, "Start distance", around_, 1, 5, "± %d cells",
                            {.help = "How far from the expert's start the agent is put, in cells of the lattice"});
      break;
    case Kind::kBox:
      row("x", std::span(box_).subspan(0, 2), kX, 0, most);
      row("y", std::span(box_).subspan(2, 2), kY, 0, most);
      row("z", std::span(box_).subspan(4, 2), kZ, 0, most);
      break;
    case Kind::kFace:
      form_label(ui, "Face");
      changed |= combo(ui, "Face", face_, face_names(), {.help = "The cells of one side of the lattice"});
      break;
    case Kind::kSphere:
      row("Middle", std::span(sphere_).subspan(0, 3), kMiddle, 0, most);
      form_label(ui, "Radius, cells");
      changed |= number_field(ui, "Radius", sphere_[3], 0, most, {.help = "In cells of the lattice"});
      break;
    case Kind::kGaussian:
      form_label(ui, "σ, mm");
      changed |= number_field(ui, "Sigma", sigma_mm_, 1, 100, {.help = "Standard deviation around the expert's start"});
      form_label(ui, "Draws");
      changed |= number_field(ui, "Draws", draws_, 1, 100'000, {.help = "How many starts are drawn"});
      form_label(ui, "Seed");
      changed |= number_field(ui, "Seed", seed_, 0, 1'000'000'000, {.help = "The same seed draws the same starts"});
      break;
    case Kind::kLatin:
      form_label(ui, "Draws");
      changed |= number_field(ui, "Draws", draws_, 1, 100'000,
                              {.help = "Each axis is cut into as many parts, and each part is drawn from once"});
      form_label(ui, "Seed");
      changed |= number_field(ui, "Seed", seed_, 0, 1'000'000'000, {.help = "The same seed draws the same starts"});
      form_label(ui, "Within, cells");
      changed |= number_field(ui, "Within", near_, 0, most,
                              {.help = "Of the expert's start, to either side; 0: anywhere in the lattice"});
      break;
    case Kind::kFile:
      form_label(ui, "File");
      changed |=
          text_field(ui, "Start file", file_, "starts.csv", {.help = "Columns i, j and k; one start for each line"});
      break;
    case Kind::kAll:
    case Kind::kPainted:
      break;
  }
  return changed;
}

void RolloutStarts::draw(Ui& ui, const WorkbenchState& state, Requests& requests) {
  take_over(state);
  const learning::Model& model = *state.insight->entry->model;
  const int most = model.grid.n - 1;
  form_label(ui, "Starts");
  bool changed = combo(ui, "Starts", kind_, kind_names(), {.help = "Where the agent is put"});
  const bool painted = static_cast<Kind>(kind_) == Kind::kPainted;
  const bool to_name = static_cast<Kind>(kind_) == Kind::kFile && file_.empty();
  changed |= draw_numbers(ui, most);
  if (painted && !state.rollouts.starts.starts_with("cells:")) {
    wrapped_text(ui, "Choose Paint below the map of outcomes, and paint cells with the mouse", ui.theme().text_dim);
  }
  if (static_cast<Kind>(kind_) == Kind::kFile && file_.empty()) {
    wrapped_text(ui, "Type a file; until then the starts are those from before", ui.theme().text_dim);
  }
  if (changed && !painted && !to_name) choose_starts(state, text(most), requests);
  if (!state.insight->starts_error.empty()) wrapped_text(ui, state.insight->starts_error, ui.theme().danger);
}

}  // namespace trocar::ui
