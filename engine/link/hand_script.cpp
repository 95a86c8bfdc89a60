#include "engine/link/hand_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

namespace trocar::link {
namespace {

constexpr double kLongestScript_s = 3600.0;
constexpr double kLongestMove_s = 60.0;
constexpr double kWidest_m = 0.5;
constexpr double kWidest_deg = 180.0;
constexpr std::size_t kMostActs = 10'000;
constexpr double kRadian_deg = std::numbers::pi / 180.0;
constexpr std::string_view kActs =
    "an act is agent or clutch with down or up, move X Y Z over S, turn X Y Z over S, grip DEG over S, away, back or "
    "end";

using Words = std::vector<std::string_view>;

Words words_in(std::string_view line) {
  line = line.substr(0, line.find('#'));
  Words words;
  std::size_t begin = 0;
  while ((begin = line.find_first_not_of(" \t\r", begin)) != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

Result<double> number_in(std::string_view word, double low, double high) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !(value >= low && value <= high)) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no number from {:g} to {:g}", word, low, high));
  }
  return value;
}

/// "X Y Z over S" or "X over S", from the third word on.
Status read_move(const Words& words, std::size_t count, double widest, std::array<double, 3>& values, double& over_s) {
  if (words.size() != 4 + count || words[2 + count] != "over") {
    return fail(ErrorCode::kInvalidArgument, std::string(kActs));
  }
  for (std::size_t i = 0; i < count; ++i) {
    TROCAR_ASSIGN_OR_RETURN(values[i], number_in(words[2 + i], -widest, widest));
  }
  TROCAR_ASSIGN_OR_RETURN(over_s, number_in(words[3 + count], 0.01, kLongestMove_s));
  return {};
}

Result<HandScript::Move> move_from(const Words& words, double at_s) {
  HandScript::Move move;
  move.at_s = at_s;
  std::array<double, 3> values{};
  if (words[1] == "move") {
    TROCAR_RETURN_IF_ERROR(read_move(words, 3, kWidest_m, values, move.over_s));
    move.way_D = {values[0], values[1], values[2]};
  } else if (words[1] == "turn") {
    TROCAR_RETURN_IF_ERROR(read_move(words, 3, kWidest_deg, values, move.over_s));
    move.turn_D = Eigen::Vector3d(values[0], values[1], values[2]) * kRadian_deg;
  } else {
    TROCAR_RETURN_IF_ERROR(read_move(words, 1, kWidest_deg, values, move.over_s));
    move.grip_rad = values[0] * kRadian_deg;
  }
  return move;
}

std::optional<HandScript::Press> press_from(const Words& words, double at_s) {
  using Switch = HandScript::Switch;
  if (words.size() == 2 && (words[1] == "away" || words[1] == "back")) {
    return HandScript::Press{at_s, Switch::kPresent, words[1] == "back"};
  }
  if (words.size() != 3 || (words[1] != "agent" && words[1] != "clutch")) return std::nullopt;
  if (words[2] != "down" && words[2] != "up") return std::nullopt;
  return HandScript::Press{at_s, words[1] == "agent" ? Switch::kAgent : Switch::kClutch, words[2] == "down"};
}

double share_of(const HandScript::Move& move, double t_s) {
  const double u = std::clamp((t_s - move.at_s) / move.over_s, 0.0, 1.0);
  return u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
}

}  // namespace

Result<HandScript> parse_hand_script(std::string_view text) {
  HandScript script;
  int number = 0;
  double last_s = 0.0;
  bool ended = false;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const Words words = words_in(text.substr(begin, end - begin));
    begin = end + 1;
    ++number;
    if (words.empty()) continue;
    const auto refuse = [number](const std::string& why) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("line {}: {}", number, why));
    };
    const auto at_s = number_in(words[0], 0.0, kLongestScript_s);
    if (!at_s) return refuse(at_s.error().text());
    if (*at_s < last_s) return refuse("time runs backwards");
    if (ended) return refuse("after the end there is nothing");
    if (script.moves_.size() + script.presses_.size() == kMostActs) return refuse("there are too many acts");
    last_s = *at_s;
    if (words.size() == 2 && words[1] == "end") {
      ended = true;
      script.end_s_ = *at_s;
    } else if (words.size() > 1 && (words[1] == "move" || words[1] == "turn" || words[1] == "grip")) {
      const auto move = move_from(words, *at_s);
      if (!move) return refuse(move.error().text());
      script.moves_.push_back(*move);
      script.end_s_ = std::max(script.end_s_, *at_s + move->over_s);
    } else if (const auto press = words.size() > 1 ? press_from(words, *at_s) : std::nullopt) {
      script.presses_.push_back(*press);
      script.end_s_ = std::max(script.end_s_, *at_s);
    } else {
      return refuse(std::string(kActs));
    }
  }
  return script;
}

HandFrame HandScript::at(double t_s) const {
  HandFrame frame;
  Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();
  for (const Move& move : moves_) {
    if (move.at_s > t_s) break;
    const double share = share_of(move, t_s);
    frame.left.X_DH.p += share * move.way_D;
    frame.left.grip_rad += share * move.grip_rad;
    const double angle = move.turn_D.norm();
    if (angle > 0.0) turned = Eigen::Quaterniond(Eigen::AngleAxisd(share * angle, move.turn_D / angle)) * turned;
  }
  frame.left.X_DH.q = turned.normalized();
  frame.left.X_DH.p = frame.left.X_DH.p.cwiseMax(-1.0).cwiseMin(1.0);
  frame.left.grip_rad = std::clamp(frame.left.grip_rad, -1.0, 2.0);
  for (const Press& press : presses_) {
    if (press.at_s > t_s) break;
    if (press.which == Switch::kPresent) frame.present = press.down;
    if (press.which == Switch::kAgent) {
      frame.agent_presses += press.down && !frame.agent_pedal ? 1 : 0;
      frame.agent_pedal = press.down;
    }
    if (press.which == Switch::kClutch) {
      frame.clutch_presses += press.down && !frame.clutch_pedal ? 1 : 0;
      frame.clutch_pedal = press.down;
    }
  }
  return frame;
}

}  // namespace trocar::link
