/// Numbers as people read them; millimetres and degrees exist only here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/spatial/grid.h"

namespace trocar::ui {

/// "12.40 s"
std::string seconds(double s);
/// How long a computation took: "12.40 s", "340 ms", "3.2 ms".
std::string elapsed(double s);
/// "0:12.4", "1:02:03.4": a place in time.
std::string time_code(double s);
/// "2,480"
std::string count(std::int64_t number);
/// "1 error", "2 errors"
std::string counted(std::size_t number, std::string_view noun);
/// "12.50 mm"
std::string millimetres(double metres);
/// "73 %", one decimal below 10 unless whole; "–" of nothing.
std::string percent(std::int64_t part, std::int64_t whole);
/// Three significant digits with a true minus sign; "–" for what is not a number.
std::string number(double value);
/// "+x" or "−x", with a true minus sign.
std::string_view direction_words(spatial::Action action);
/// The eight first digits of a hash.
std::string short_hash(std::uint64_t hash);
/// "2026-03-01 12:03" of an ISO 8601 time; anything else as it is.
std::string shown_time(const std::string& iso);
/// "undo layout" of "Undo layout": the letters of English.
std::string lower_case(std::string_view text);
/// "~/work/a.trocar": the home folder shortened.
std::string shown_path(const std::filesystem::path& path);

}  // namespace trocar::ui
