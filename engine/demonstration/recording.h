/// What was recorded, once and for good: samples of both arms, the blocks, the pedals, and who made them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/id.h"
#include "engine/core/result.h"
#include "engine/core/tick.h"
#include "engine/peg_board/peg_board.h"
#include "engine/spatial/pose.h"

namespace trocar::demonstration {

using RecordingId = Id<struct RecordingTag>;

/// A pose in single precision, for what is only shown or measured: 28 bytes.
struct CompactPose {
  std::array<float, 3> p{};
  std::array<float, 4> q_wxyz{1.0F, 0.0F, 0.0F, 0.0F};

  static CompactPose from(const spatial::Pose& pose);
  spatial::Pose pose() const;
};

/// The paper's five segments (Fig. 1).
enum class Segment : std::uint8_t { kA, kB, kC, kD, kE };
constexpr int kSegmentCount = 5;
/// 'A' … 'E'.
char letter(Segment segment);

/// Who moves the left arm.
enum class Authority : std::uint8_t { kOperator, kAgent, kAssistant, kHold };
std::string_view to_string(Authority authority);

/// One arm in one sample. The setpoint is exact (replay depends on it), the rest is rounded to single precision.
struct ArmSample {
  std::array<double, 3> setpoint_p{};                 ///< p_WT, metres.
  std::array<double, 4> setpoint_q_wxyz{1, 0, 0, 0};  ///< R_WT.
  double setpoint_jaw_rad = 0.0;
  CompactPose measured;  ///< X_WT.
  float jaw_rad = 0.0F;
  std::array<float, 6> joints{};  ///< As `kinematics::Joints`.

  spatial::Pose setpoint() const;
  void set_setpoint(const spatial::Pose& X_WT, double jaw_rad_in);
};

/// Pedals and contacts as bits of `Sample::flags`.
enum SampleFlag : std::uint32_t {
  kAgentPedal = 1U << 0,
  kClutchPedal = 1U << 1,
  kLeftHolds = 1U << 2,  ///< Both jaws of the left arm touch the target block.
  kRightHolds = 1U << 3,
};

/// One instant, every 5 ticks (200 Hz). Plain bytes: chunks of samples are stored as they are in memory.
/// False for a block whose place nobody recorded: it is left where nothing can be, in the origin.
inline bool is_known(const CompactPose& block) {
  return block.p != std::array<float, 3>{};
}

struct Sample {
  std::int64_t tick = 0;
  std::array<ArmSample, 2> arms;  ///< Left (PSM2), right (PSM1).
  std::array<CompactPose, peg_board::kBlockCount> blocks;
  std::uint32_t flags = 0;
  Authority authority = Authority::kOperator;
  Segment segment = Segment::kA;  ///< The segment that the recorder's task was in.
  std::uint16_t reserved = 0;

  double t_s() const { return Tick{tick}.seconds(); }
};

constexpr int kTicksPerSample = 5;
constexpr double kSampleRate_hz = 200.0;

/// In place of a block's or a peg's number: nobody said which.
constexpr int kUnknownPlace = -1;

/// Where a recording comes from; what a script made is never passed off as a person's.
struct Provenance {
  std::string operator_kind;  ///< "scripted", "person" or "imported".
  std::string skill;          ///< Of a scripted operator: expert, trained, novice.
  std::string device;
  std::uint64_t seed = 0;
  int block = 0;  ///< Target block and start peg, 0 … 5, or `kUnknownPlace`.
  int goal = 0;   ///< Goal peg, 0 … 5, or `kUnknownPlace`.
  std::string scene_hash;
  std::string software;  ///< "trocar 0.1.0"
  std::string created;   ///< ISO 8601, UTC.
};

/// A state hash of the world at a tick, to verify a replay against.
struct HashMark {
  std::int64_t tick = 0;
  std::uint64_t hash = 0;
};

/// How a transfer ended (shared control, "Trial"); unknown where the file that it was imported from does not tell.
enum class Outcome : std::uint8_t { kUnfinished, kSuccess, kDropped, kAborted, kFault, kUnknown };
std::string_view to_string(Outcome outcome);

/// All of a recording but its samples: what the document keeps, beside the samples packed.
struct RecordingInfo {
  RecordingId id;
  Provenance provenance;
  Outcome outcome = Outcome::kUnfinished;
  bool placed = false;           ///< Block seated on the goal peg, both grippers open.
  bool recovered = false;        ///< Salvaged after a crash: what was committed until then.
  std::string initial_world;     ///< `simulation::WorldSnapshot::bytes` before the first sample; may be empty.
  std::vector<HashMark> hashes;  ///< Every second, and at the end.
};

/// As it is made and imported. Immutable once finished.
struct Recording : RecordingInfo {
  std::vector<Sample> samples;  ///< By increasing tick.

  /// Of samples, provenance, initial world and hashes.
  std::uint64_t content_hash() const;
};

/// Hashes samples as they come; independent of how they were grouped.
class SampleHasher {
 public:
  void add(const Sample& sample);
  std::uint64_t digest() const;

 private:
  std::array<std::uint64_t, 4> lanes_{0x9E3779B97F4A7C15ULL, 0xC2B2AE3D27D4EB4FULL, 0x165667B19E3779F9ULL,
                                      0x27D4EB2F165667C5ULL};
  std::uint64_t count_ = 0;
};
std::uint64_t hash_of(std::span<const Sample> samples);

/// `Recording::content_hash` for who does not hold all samples at once.
std::uint64_t content_hash(std::uint64_t samples_hash, const Provenance& provenance, std::string_view initial_world,
                           std::span<const HashMark> hashes);

bool is_finite(const Sample& sample);

/// Errors: kInvalidArgument naming the sample that is not finite, out of order, or has a label or tick out of range.
Status check_samples(std::span<const Sample> samples);

}  // namespace trocar::demonstration
