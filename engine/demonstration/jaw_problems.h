/// What is wrong with what the grippers do: closing on nothing, a block that changes hands in the air. Private to the
/// module.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/demonstration/problems.h"

namespace trocar::demonstration {

/// Goes through the gated samples in their order, once; what it says is meant only if all of them are finite.
class JawChecks {
 public:
  void add(const Sample& sample, double t_s);
  void report(std::vector<Problem>& found) const;

 private:
  void check_closing(const Sample& sample, double t_s, std::size_t arm);
  void check_hand_off(const Sample& sample, double t_s);

  std::array<bool, 2> open_{};
  std::array<std::vector<Problem>, 2> closings_;
  double left_until_s_ = -1.0;
  bool together_ = false;
  bool handed_over_ = false;
  std::optional<Problem> hand_off_;
};

}  // namespace trocar::demonstration
