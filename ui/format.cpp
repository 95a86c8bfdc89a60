#include "ui/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "engine/spatial/units.h"
#include "engine/statistics/proportion.h"

namespace trocar::ui {

std::string seconds(double s) {
  return fmt::format("{:.2f} s", s);
}

std::string elapsed(double s) {
  if (s >= 1.0) return seconds(s);
  const double ms = 1000.0 * s;
  return fmt::format("{:.{}f} ms", ms, ms >= 10.0 ? 0 : ms >= 0.1 ? 1 : 2);
}

std::string time_code(double s) {
  // Tenths first, so that 59.96 s is 1:00.0 and never 0:60.0.
  const auto tenths = static_cast<std::int64_t>(std::llround(std::max(s, 0.0) * 10.0));
  const std::int64_t minutes = tenths / 600;
  const double rest = static_cast<double>(tenths % 600) / 10.0;
  if (minutes >= 60) return fmt::format("{}:{:02}:{:04.1f}", minutes / 60, minutes % 60, rest);
  return fmt::format("{}:{:04.1f}", minutes, rest);
}

std::string count(std::int64_t value) {
  const std::string digits = std::to_string(value < 0 ? -value : value);
  std::string text = value < 0 ? "−" : "";
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string counted(std::size_t number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

std::string millimetres(double metres) {
  return number(spatial::to_mm(metres)) + " mm";
}

std::string percent(std::int64_t part, std::int64_t whole) {
  if (whole <= 0) return "–";
  const double share = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  // What is not all is not called 100 %.
  const bool plain = (share >= 10.0 && share < 99.5) || share == std::floor(share);
  return statistics::percent_text(part, whole, plain ? 0 : 1);
}

std::string number(double value) {
  if (!std::isfinite(value)) return "–";
  std::string text = fmt::format("{:.3g}", value);
  if (text.front() == '-') return fmt::format("−{}", text.substr(1));
  return text;
}

std::string short_hash(std::uint64_t hash) {
  return fmt::format("{:016x}", hash).substr(0, 8);
}

std::string shown_time(const std::string& iso) {
  if (iso.size() < 16 || iso[10] != 'T') return iso;
  return fmt::format("{} {}", iso.substr(0, 10), iso.substr(11, 5));
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::string_view direction_words(spatial::Action action) {
  constexpr std::array<std::string_view, spatial::kActionCount> kNames{"+x", "−x", "+y", "−y", "+z", "−z"};
  return kNames[static_cast<std::size_t>(action)];
}

std::string shown_path(const std::filesystem::path& path) {
  std::string text = path.string();
  const char* home = std::getenv("HOME");
  const std::string folder = fmt::format("{}/", home == nullptr ? "" : home);
  if (folder.size() > 1 && text.starts_with(folder)) return fmt::format("~/{}", text.substr(folder.size()));
  return text;
}

}  // namespace trocar::ui
