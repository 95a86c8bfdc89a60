#include "engine/film/subtitles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trocar::film {
namespace {

/// "00:01:02,345"; the two formats differ in the mark before the thousandths.
std::string stamp(double seconds, char mark) {
  const auto ms = static_cast<long long>(std::llround(std::max(0.0, seconds) * 1000.0));
  return fmt::format("{:02}:{:02}:{:02}{}{:03}", ms / 3'600'000, ms / 60'000 % 60, ms / 1000 % 60, mark, ms % 1000);
}

std::string without_blank_lines(const std::string& text) {
  std::string kept;
  for (const char c : text) {
    if (c == '\r' || (c == '\n' && (kept.empty() || kept.back() == '\n'))) continue;
    kept.push_back(c);
  }
  while (!kept.empty() && kept.back() == '\n') kept.pop_back();
  return kept;
}

std::string with_entities(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else {
      out.push_back(c);
    }
  }
  return out;
}

}  // namespace

std::vector<Cue> cues_of(const std::vector<std::string>& frames, double fps) {
  std::vector<Cue> cues;
  for (std::size_t from = 0; from < frames.size();) {
    std::size_t to = from + 1;
    while (to < frames.size() && frames[to] == frames[from]) ++to;
    if (!frames[from].empty()) {
      cues.push_back({static_cast<double>(from) / fps, static_cast<double>(to) / fps, frames[from]});
    }
    from = to;
  }
  return cues;
}

std::string srt_of(const std::vector<Cue>& cues) {
  std::string srt;
  int number = 0;
  for (const Cue& cue : cues) {
    const std::string text = without_blank_lines(cue.text);
    if (text.empty()) continue;
    srt += fmt::format("{}\n{} --> {}\n{}\n\n", ++number, stamp(cue.begin_s, ','), stamp(cue.end_s, ','), text);
  }
  return srt;
}

std::string vtt_of(const std::vector<Cue>& cues) {
  std::string vtt = "WEBVTT\n\n";
  for (const Cue& cue : cues) {
    const std::string text = with_entities(without_blank_lines(cue.text));
    if (text.empty()) continue;
    vtt += fmt::format("{} --> {}\n{}\n\n", stamp(cue.begin_s, '.'), stamp(cue.end_s, '.'), text);
  }
  return vtt;
}

}  // namespace trocar::film
