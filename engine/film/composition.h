/// A film as data: what is shown where, by which camera, at which pace, and what is written over it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/film/keyframes.h"

namespace trocar::film {

enum class Layout : std::uint8_t { kSingle, kSideBySide, kTopBottom, kTwoByTwo, kThreeByThree, kPictureInPicture };
/// How many sources a layout has room for, and how many it needs.
struct Room {
  std::size_t least = 1;
  std::size_t most = 1;
};
Room room_of(Layout layout);
/// The layout for so many sources: `wanted`, if that is what it shows when it is full; else by their number.
Layout layout_for(Layout wanted, std::size_t sources);

enum class Corner : std::uint8_t { kTopLeft, kTopRight, kBottomLeft, kBottomRight };

/// What begins together in all sources: the film; each of the segments A to E; what comes before the left gripper first
/// holds the block, and what comes after.
enum class Sync : std::uint8_t { kClock, kSegment, kGrasp };

/// Of the drawing: one sample a pixel, or four with softer shadows.
enum class Quality : std::uint8_t { kFast, kFine };

enum class View : std::uint8_t { kPaper, kTop, kSide, kFront, kOrbit, kTurntable, kPoses, kFollow };

/// Where the camera is from its own time on: at `eye_m`, looking at `target_m` (W).
struct CameraKey {
  double t_s = 0.0;  ///< Of the film.
  std::array<double, 3> eye_m{0.1015, 0.0, 0.0829};
  std::array<double, 3> target_m{-0.0421, 0.0, 0.0};
  Ease ease = Ease::kSmooth;
  bool operator==(const CameraKey&) const = default;
};

struct CameraPath {
  View view = View::kPaper;
  double yaw_rad = 0.5;  ///< Of orbit and turntable: about the lattice.
  double elevation_rad = 0.6;
  double distance_m = 0.21;     ///< … and of follow.
  double turn_s = 12.0;         ///< Of a turntable: film seconds for once around; negative: the other way.
  double zoom = 1.0;            ///< 2: twice as large as the view has it.
  std::vector<CameraKey> keys;  ///< Of poses: at least one, by increasing time.
  bool operator==(const CameraPath&) const = default;
};

enum class SourceKind : std::uint8_t { kRecording, kField, kCurve, kRollout };

/// A slice of a model's field, seen in the scene.
struct SceneField {
  std::string of;  ///< Id or name of a model.
  std::string layer = "value";
  std::string slice = "z=11";
  double opacity = 0.8;
  bool operator==(const SceneField&) const = default;
};

struct Source {
  SourceKind kind = SourceKind::kRecording;
  std::string of;              ///< Id or name of a demonstration or trial; of a field or rollout, of a model.
  std::string title;           ///< Empty: its name.
  CameraPath camera;           ///< Of a recording or rollout.
  std::optional<double> in_s;  ///< Of the recording's own time; none: its gates.
  std::optional<double> out_s;
  std::string layer = "value";              ///< Of a field …
  std::string slice = "z=11";               ///< … and where it is cut.
  std::string curve = "speed";              ///< As `trocar demo plot` calls them.
  std::optional<std::array<int, 3>> start;  ///< Of a rollout, in cells; none: where the model's first expert began.
  std::optional<SceneField> field;          ///< In the scene of a recording or rollout.
  double trail_s = 4.0;                     ///< How long the tips' trail is, where it is drawn.
  double ghost = 0.3;                       ///< How dense the ghost is, where it is drawn: 0 … 1.
  double brightness = 1.0;                  ///< 0: black.
  std::vector<Track> tracks;                ///< Of properties that such a source has (`film/property.h`).
  bool operator==(const Source&) const = default;
};

/// A demonstration or trial, as it is if nothing else is said.
Source recording_of(std::string name);

/// The picture stands for `for_s` film seconds when `at_s` is reached, of what all sources have in common: their time
/// from the begin, those that wait included.
struct Hold {
  double at_s = 0.0;
  double for_s = 1.0;
  bool operator==(const Hold&) const = default;
};

struct Pace {
  double speed = 1.0;      ///< Seconds of the sources for each second of film, without `ramps`.
  std::vector<Key> ramps;  ///< The speed by film time, in which holds do not count.
  std::vector<Hold> holds;
  int loops = 1;
  Sync sync = Sync::kClock;
  bool operator==(const Pace&) const = default;
};

enum class Overlay : std::uint8_t {
  kTitle,
  kTimer,
  kSegment,
  kAuthority,
  kPedals,
  kJaws,
  kMetrics,
  kTally,
  kColourBar,
  kScaleBar,
  kTrail,
  kGhost,
  kCaptions,
  kProvenance,
  kSpeed
};
constexpr std::size_t kOverlayCount = 15;

/// Which overlays are on. That a source was made by a script is written in any case.
class Overlays {
 public:
  constexpr Overlays() = default;
  /// All but metrics, tally, trail, ghost and captions: what a film of a transfer has if nothing is said.
  static Overlays usual();

  constexpr bool has(Overlay overlay) const { return (bits_ & bit(overlay)) != 0; }
  constexpr void set(Overlay overlay, bool on = true) { bits_ = on ? bits_ | bit(overlay) : bits_ & ~bit(overlay); }
  constexpr bool operator==(const Overlays&) const = default;

 private:
  static constexpr std::uint32_t bit(Overlay overlay) { return std::uint32_t{1} << static_cast<unsigned>(overlay); }
  std::uint32_t bits_ = 0;
};

struct Composition {
  std::string path;  ///< Empty: whoever renders it says.
  int width = 1280;  ///< Made even by adding a column or row.
  int height = 720;
  double fps = 30.0;
  std::string codec = "auto";
  std::optional<int> crf;  ///< How much the file may lose, 1 to 63; none: what the codec usually has.
  Quality quality = Quality::kFast;
  Layout layout = Layout::kSingle;
  Corner corner = Corner::kBottomRight;  ///< Of the second picture, where it lies in the first …
  double share = 0.3;                    ///< … and how much of its width it has, 0.1 … 0.5 …
  std::vector<Key> share_keys;           ///< … by film time, if it changes.
  std::vector<Source> sources;
  Pace pace;
  Overlays overlays = Overlays::usual();
  bool operator==(const Composition&) const = default;
};

/// Errors: kInvalidArgument for what no film can be: sizes, rates, a number of sources that the layout has no room for,
/// keys out of order, a property that there is not.
Status check(const Composition& composition);

/// "paper-1080p", "slide-720p", "mt-vs-sc", "thumbnail": without sources. Errors: kInvalidArgument with these names.
Result<Composition> preset_from(std::string_view name);
const std::vector<std::string_view>& preset_names();

}  // namespace trocar::film
