/// What is said in a film and when, as files beside it (SubRip, WebVTT).
#pragma once

#include <string>
#include <vector>

namespace trocar::film {

struct Cue {
  double begin_s = 0.0;  ///< Of the film.
  double end_s = 0.0;
  std::string text;  ///< One line or several; never empty.
};

/// From what is said in each frame: equal texts that follow each other are one cue, empty ones none.
std::vector<Cue> cues_of(const std::vector<std::string>& frames, double fps);

/// The cues by number, as .srt. Blank lines within a text, which would end it, are left out.
std::string srt_of(const std::vector<Cue>& cues);
/// The same as WebVTT, which pages show: in it "&", "<" and ">" are written as entities.
std::string vtt_of(const std::vector<Cue>& cues);

}  // namespace trocar::film
