/// What is written over the frames of a film: who moves the tool, which segment, when, and where the film comes from.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/image.h"
#include "engine/demonstration/recording.h"
#include "engine/film/colour_key.h"
#include "engine/film/composition.h"

namespace trocar::film {

/// The dark strip at the foot: all in one row; in two, for a picture that is not wide; without pedals and jaws, for a
/// small one; or none.
enum class Band : std::uint8_t { kOneRow, kTwoRows, kShort, kNone };
/// What suits a picture of that size; none if there is nothing to be written in it.
Band band_for(const Overlays& shown, int width, int height);
/// The length in pixels of what is 1 in a frame of 1280 × 720, and the rows that the band covers.
double unit_of(Band band, int width, int height);
int band_height_of(Band band, int width, int height);
/// In those units, 5 % of the height: inside what every player shows.
constexpr double kMargin = 36.0;

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
  std::array<double, 2> jaw_rad{};     ///< Opening, left and right.
  std::string provenance;              ///< Below all: "scripted expert, seed 1".
  double speed = 1.0;                  ///< Of playback; shown unless 1; 0: the picture is held.
  std::string caption;                 ///< One line in the middle, above the band.
  std::string status;                  ///< Above that, larger: "waiting".
  std::vector<std::string> lines;      ///< Below the title: measures.
  bool lines_at_right = false;         ///< … or in the other corner, if something lies there.
  std::optional<ColourKey> colours;    ///< At the right: what the colours of a field in the scene mean …
  bool colours_at_left = false;        ///< … or below the lines, if something lies there.
  bool scripted = false;               ///< Said below the title unless the band's provenance is shown.
  Overlays shown = Overlays::usual();  ///< Which parts the band has.
};

/// Draws captions on frames of one size, the same look at every size from 320 × 180 up; every part is told by word or
/// shape as well as by colour. What is drawn depends on the frame and its caption alone. Threads: one at a time.
class FilmOverlay {
 public:
  /// Precondition: positive.
  FilmOverlay(int width, int height, Band band = Band::kOneRow);
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

}  // namespace trocar::film
