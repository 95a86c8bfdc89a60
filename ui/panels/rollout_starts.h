/// Which starts: around the expert's, all, a box, a face, a sphere, drawn at random, from a file, or painted.
#pragma once

#include "ui/panel.h"

namespace trocar::ui {

class RolloutStarts {
 public:
  void draw(Ui& ui, const WorkbenchState& state, Requests& requests);

 private:
  enum class Kind { kAround, kAll, kBox, kFace, kSphere, kGaussian, kLatin, kFile, kPainted };
  void take_over(const WorkbenchState& state);
  std::string text(int most) const;
  bool draw_numbers(Ui& ui, int most);

  std::string shown_;  ///< What the fields below were taken from.
  int kind_ = 0;
  int around_ = 3;
  std::array<std::int64_t, 6> box_{0, 21, 0, 21, 0, 21};
  int face_ = 5;
  std::array<std::int64_t, 4> sphere_{11, 11, 11, 3};
  std::int64_t sigma_mm_ = 5;
  std::int64_t draws_ = 200;
  std::int64_t seed_ = 1;
  std::int64_t near_ = 0;  ///< Of a Latin hypercube, cells; 0: the whole lattice.
  std::string file_;
};

}  // namespace trocar::ui
