/// What is written over the frames of a film: who moves the tool, which segment, when, and where the film comes from.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "engine/core/image.h"
#include "engine/demonstration/recording.h"

namespace trocar::film {

/// All that the captions of one frame say. Empty texts are left out.
struct FrameCaption {
  std::string title;        ///< Top left, bold: "scripted expert, block 0 to peg 0".
  double time_s = 0.0;      ///< Since the begin of what is shown.
  double duration_s = 0.0;  ///< 0: no progress line.
  std::optional<demonstration::Segment> segment;
  double segment_progress = 0.0;  ///< 0 … 1.
  demonstration::Authority authority = demonstration::Authority::kOperator;
  bool agent_pedal = false;
  bool clutch_pedal = false;
  std::array<double, 2> jaw_rad{};  ///< Opening, left and right.
  std::string provenance;           ///< Below all: "scripted expert, seed 1".
  double speed = 1.0;               ///< Of playback; shown unless 1.
  std::string caption;              ///< One line in the middle, above the band.
};

/// Draws captions on frames of one size, the same look at every size from 320 × 180 up; every part is told by word or
/// shape as well as by colour. What is drawn depends on the frame and its caption alone. Threads: one at a time.
class FilmOverlay {
 public:
  /// Precondition: positive.
  FilmOverlay(int width, int height);
  ~FilmOverlay();
  FilmOverlay(FilmOverlay&&) noexcept;
  FilmOverlay& operator=(FilmOverlay&&) noexcept;

  /// Rows at the foot that the captions cover from side to side: a picture above them is seen whole.
  int band_height() const;
  /// Precondition: `frame` is of the overlay's size.
  void draw(Image& frame, const FrameCaption& caption);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Two pictures of equal height in one, as wide as both, with a dividing line and their names at the top. Pictures of
/// unequal height are placed from the top, on black.
Image side_by_side(const Image& left, const Image& right, const std::string& left_name, const std::string& right_name);

}  // namespace trocar::film
