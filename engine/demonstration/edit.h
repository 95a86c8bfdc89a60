/// Edits of one demonstration as data: what an expert can do to it, with all that is needed to do it again.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/core/result.h"
#include "engine/demonstration/note.h"
#include "engine/demonstration/recording.h"

namespace trocar::demonstration {

struct Clip;

// Times are seconds of the demonstration that the edit is applied to (0 = the recording's first sample). `kName` is the
// word for the edit in files and on the command line, `kHelp` one line for people.

struct Trim {
  static constexpr std::string_view kName = "trim";
  static constexpr std::string_view kHelp = "Move the gates; the recording keeps everything";
  double from_s = 0.0;
  double to_s = 0.0;
};

/// Moves the gates past what does not move at the ends, and cuts out pauses inside.
struct TrimIdle {
  static constexpr std::string_view kName = "trim-idle";
  static constexpr std::string_view kHelp = "Leave out idle ends, and pauses inside too if asked";
  double speed_m_s = 0.002;  ///< Slower is idle.
  double longer_s = 0.3;     ///< Shorter pauses stay.
  double keep_s = 0.1;       ///< What stays of each.
  bool ends = true;
  bool inside = false;
  double window_s = 0.0;  ///< Speeds are measured over so long before and after; 0: as the rate of the samples allows.
  int keep_samples = 0;   ///< Not 0: that many stay of each, in place of `keep_s`.
  std::vector<double> stay_s{};  ///< What is idle at one of these times stays whole.
};

struct Rename {
  static constexpr std::string_view kName = "rename";
  static constexpr std::string_view kHelp = "Give another name";
  std::string name;
};

/// What it covers of other spans is cut away, a span it splits becomes two.
struct LabelSegment {
  static constexpr std::string_view kName = "label";
  static constexpr std::string_view kHelp = "Say which segment a span is";
  Segment label = Segment::kA;
  double from_s = 0.0;
  double to_s = 0.0;
};

/// Labels from what was recorded: the distance to the block, who holds it, the hand-over.
struct ProposeLabels {
  static constexpr std::string_view kName = "propose-labels";
  static constexpr std::string_view kHelp = "Label segments A to E from distances, grasps and the hand-over";
};

/// Takes samples out.
struct DeleteSpan {
  static constexpr std::string_view kName = "delete";
  static constexpr std::string_view kHelp = "Take a span out, closing the gap or leaving it";
  double from_s = 0.0;
  double to_s = 0.0;
  bool ripple = true;  ///< What follows moves up; false: a gap stays, to be bridged.
};

/// Where a clip's arms go: as they were, translated so that each goes on from where it is, or from the source's start
/// peg to this demonstration's.
enum class Align : std::uint8_t { kAsRecorded, kMeet, kPeg };
/// Puts a run of this or of another demonstration in; what follows moves.
struct Splice {
  static constexpr std::string_view kName = "splice";
  static constexpr std::string_view kHelp = "Put in a run of this or of another demonstration";
  std::int64_t source = 0;   ///< The demonstration that it is taken from.
  double clip_from_s = 0.0;  ///< Times of the source.
  double clip_to_s = 0.0;
  double at_s = 0.0;
  double until_s = 0.0;  ///< The clip replaces what lies between; 0: nothing.
  Align align = Align::kMeet;
  std::int64_t as_of = 0;  ///< The point of the project's history at which the source is meant; 0: now.
  /// What the source was then. Not stored: found again from the history, and null until it is.
  std::shared_ptr<const Clip> clip;
  int peg = -1;  ///< Of `Align::kPeg`: to which start peg; −1: this demonstration's.
};

enum class Arms : std::uint8_t { kLeft, kRight, kBoth };

/// Arms do what a run of this or of another demonstration has them do, and the blocks with them. Nothing moves in time:
/// the other arm, labels, gates and all else stay; what would lie beyond the end is left out.
struct Overdub {
  static constexpr std::string_view kName = "overdub";
  static constexpr std::string_view kHelp = "Replace what an arm does by what it does elsewhere; nothing else moves";
  std::int64_t source = 0;   ///< The demonstration that it is taken from.
  double clip_from_s = 0.0;  ///< Times of the source.
  double clip_to_s = 0.0;
  double at_s = 0.0;
  Arms arms = Arms::kLeft;
  double ease_s = 0.5;     ///< After it, the arms come back to what they did within this time; 0: they jump.
  std::int64_t as_of = 0;  ///< As of a splice.
  std::shared_ptr<const Clip> clip;
};

/// Straight on or with minimum jerk; as the learned policy of a model goes; or up, over everything on the board, and
/// down again, each with minimum jerk.
enum class BridgeShape : std::uint8_t { kStraight, kMinimumJerk, kPolicy, kOver };
/// A new motion between two instants, in place of what is there, or of nothing.
struct Bridge {
  static constexpr std::string_view kName = "bridge";
  static constexpr std::string_view kHelp =
      "Replace a span by a new motion between its ends: straight, smooth, by a policy or over the pegs";
  double from_s = 0.0;
  double to_s = 0.0;
  Arms arms = Arms::kBoth;
  BridgeShape shape = BridgeShape::kMinimumJerk;
  double peak_speed_m_s = 0.0;  ///< Sets the duration; 0: as long as the span is.
  /// p_WT that the left (or only) arm passes. Of a policy: its way, which the workbench finds when the edit is made.
  std::vector<Eigen::Vector3d> via_m;
  std::int64_t model = 0;  ///< Whose policy; 0: the newest of the segment at the begin.
  double rate_hz = 0.0;    ///< Of the new samples; 0: as on either side of the bridge.
};

/// How a displacement fades with the time from its middle, from 1 to 0.
enum class Falloff : std::uint8_t { kSmooth, kSphere, kLinear, kSharp };
/// Moves one tool at an instant, and its neighbourhood in time with it.
struct MoveTool {
  static constexpr std::string_view kName = "move";
  static constexpr std::string_view kHelp = "Move a tool at an instant, its neighbourhood in time with it";
  Arms arms = Arms::kLeft;
  double at_s = 0.0;
  Eigen::Vector3d by_m{0.0, 0.0, 0.0};  ///< In W.
  double radius_s = 0.5;
  Falloff falloff = Falloff::kSmooth;
};

enum class TurnFrame : std::uint8_t { kTool, kBoard };
struct RotateTool {
  static constexpr std::string_view kName = "rotate";
  static constexpr std::string_view kHelp = "Turn a tool about its tip at an instant, its neighbourhood with it";
  Arms arms = Arms::kLeft;
  double at_s = 0.0;
  Eigen::Vector3d by_rad{0.0, 0.0, 0.0};  ///< A rotation vector.
  TurnFrame frame = TurnFrame::kTool;
  double radius_s = 0.5;
  Falloff falloff = Falloff::kSmooth;
};

/// Moves whole arms, all along.
struct Offset {
  static constexpr std::string_view kName = "offset";
  static constexpr std::string_view kHelp = "Move everything that an arm does";
  Arms arms = Arms::kBoth;
  Eigen::Vector3d by_m{0.0, 0.0, 0.0};
};

enum class Filter : std::uint8_t { kSavitzkyGolay, kGaussian, kLowPass };
struct Smooth {
  static constexpr std::string_view kName = "smooth";
  static constexpr std::string_view kHelp = "Take tremor out of a path, ends and contacts held";
  double from_s = 0.0;
  double to_s = 0.0;
  Arms arms = Arms::kBoth;
  Filter filter = Filter::kSavitzkyGolay;
  double width_s = 0.25;           ///< Of the window.
  double max_deviation_m = 0.002;  ///< No sample moves further than this.
  bool lock_contacts = true;       ///< Nothing moves while a grasp begins or ends.
  bool lock_ends = true;           ///< It sets in and ends gently; the very ends stay in any case.
  bool lock_jaws = false;          ///< Nothing moves where a gripper opens or closes.
};

/// Keeps the fewest knots from which the path is found again within a tolerance.
struct Simplify {
  static constexpr std::string_view kName = "simplify";
  static constexpr std::string_view kHelp = "Replace a path by straight runs between the fewest knots";
  double from_s = 0.0;
  double to_s = 0.0;
  Arms arms = Arms::kLeft;
  double tolerance_m = 0.0005;
};

/// Between samples: straight, or along a cubic with the slopes of the neighbours (orientations along the shortest arc
/// in both); or the nearest sample as it is.
enum class ResampleBy : std::uint8_t { kLinear, kCubic, kNearest };
struct Resample {
  static constexpr std::string_view kName = "resample";
  static constexpr std::string_view kHelp = "Give the samples another rate";
  double rate_hz = 200.0;  ///< 1 to 1000; each sample at the whole millisecond nearest to its time.
  ResampleBy method = ResampleBy::kLinear;
};

/// `kWarp`: along a smooth curve through knots that never turns back.
enum class RetimeTo : std::uint8_t { kScale, kDuration, kSpeedCap, kConstantSpeed, kWarp };
struct Retime {
  static constexpr std::string_view kName = "retime";
  static constexpr std::string_view kHelp = "Make a span slower or faster";
  double from_s = 0.0;
  double to_s = 0.0;
  RetimeTo mode = RetimeTo::kScale;
  double scale = 1.0;  ///< Of the duration.
  double duration_s = 0.0;
  double speed_m_s = 0.05;  ///< The cap, or the constant speed, of the faster tool.
  /// How long the motion takes to get going at the begin, and to come to rest at the end. The middle keeps its speed
  /// and the span becomes longer by half of both; where the duration is given, the middle becomes faster.
  double ease_in_s = 0.0;
  double ease_out_s = 0.0;
  /// Of `kWarp`: what was at the first time comes at the second. The begin stays where it is; an end that is not named
  /// is as far behind the last knot as it was.
  std::vector<Eigen::Vector2d> knots_s{};
};

/// Moves a path onto the agent's lattice: a legal path of single actions.
struct SnapToGrid {
  static constexpr std::string_view kName = "snap";
  static constexpr std::string_view kHelp = "Move a path onto the agent's lattice, one action after the other";
  double from_s = 0.0;
  double to_s = 0.0;
  Arms arms = Arms::kLeft;
  bool keep_offset = false;  ///< The first sample stays where it is within its cell.
  bool keep_snapped = true;  ///< A span that lies on the lattice already stays as it is.
};

/// Opens or closes a gripper.
struct SetJaw {
  static constexpr std::string_view kName = "jaw";
  static constexpr std::string_view kHelp = "Open or close a gripper";
  Arms arms = Arms::kLeft;
  double from_s = 0.0;
  double to_s = 0.0;
  double jaw_rad = 0.0;
  double ramp_s = 0.2;
};

/// Each opening and closing that the trace of a jaw shows becomes one ramp between where the jaw rests before and
/// after.
struct JawEvents {
  static constexpr std::string_view kName = "jaw-events";
  static constexpr std::string_view kHelp = "Find where grippers open and close, and make each one clean ramp";
  double from_s = 0.0;
  double to_s = 0.0;
  Arms arms = Arms::kBoth;
  double ramp_s = 0.2;
};

/// Left becomes right: the picture in a mirror through x and z.
struct Mirror {
  static constexpr std::string_view kName = "mirror";
  static constexpr std::string_view kHelp = "Swap left and right";
};

/// The same transfer of another block to another peg.
struct Retarget {
  static constexpr std::string_view kName = "retarget";
  static constexpr std::string_view kHelp = "Make it a transfer of another block to another peg";
  int block = 0;
  int goal = 0;
};

struct Perturb {
  static constexpr std::string_view kName = "perturb";
  static constexpr std::string_view kHelp = "Add smooth seeded noise to the paths, ends and grasps held";
  double sigma_m = 0.001;
  double period_s = 1.0;  ///< Over which the noise changes.
  std::uint64_t seed = 1;
};

/// Whole samples of an arm, or its poses or its jaw alone; or the labels.
enum class RevertWhat : std::uint8_t { kSamples, kPose, kJaw, kLabels };
/// Brings back what was recorded in a span.
struct Revert {
  static constexpr std::string_view kName = "revert";
  static constexpr std::string_view kHelp = "Bring a span back as it was recorded: an arm or both, all or one channel";
  double from_s = 0.0;
  double to_s = 0.0;
  Arms arms = Arms::kBoth;
  RevertWhat what = RevertWhat::kSamples;
};

/// A word about an instant or a span.
struct AddNote {
  static constexpr std::string_view kName = "note";
  static constexpr std::string_view kHelp = "Write a note on an instant or a span";
  std::string text;
  double from_s = 0.0;
  double to_s = 0.0;
  std::string tag;
  int rating = 0;  ///< 0: none, else 1 to 5.
  NoteColour colour = NoteColour::kPlain;
  NoteGlyph glyph = NoteGlyph::kFlag;
};
struct RemoveNote {
  static constexpr std::string_view kName = "remove-note";
  static constexpr std::string_view kHelp = "Take a note away";
  std::int64_t note = 0;
};

using Edit = std::variant<Trim, TrimIdle, Rename, LabelSegment, ProposeLabels, DeleteSpan, Splice, Overdub, Bridge,
                          MoveTool, RotateTool, Offset, Smooth, Simplify, Resample, Retime, SnapToGrid, SetJaw,
                          JawEvents, Mirror, Retarget, Perturb, Revert, AddNote, RemoveNote>;

/// The edit's name and its parameters as a JSON object; the row of the journal.
std::string_view name_of(const Edit& edit);
std::string to_json(const Edit& edit);
/// Errors: kCorrupt for an unknown name, a missing or a foreign key, or a value of the wrong type.
Result<Edit> edit_from_json(std::string_view name, std::string_view json);

/// False for what says something about the demonstration but does not change it, such as its name: such an edit is in
/// the history but not among the edits that can be switched off or put in another order.
bool stacks(const Edit& edit);

}  // namespace trocar::demonstration
