#include "engine/simulation/world_memory.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <type_traits>

#include "engine/simulation/gripper.h"

namespace trocar::simulation {
namespace {

constexpr std::uint64_t kMagic = 0x444C524F57524F54ULL;
constexpr std::uint32_t kVersion = 1;

/// Precondition of each call: the string given is long enough.
class Writer {
 public:
  explicit Writer(std::string& bytes) : next_(bytes.data()) {}
  template <typename T>
  void operator()(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::memcpy(next_, &value, sizeof value);
    next_ += sizeof value;
  }
  void operator()(const bool& value) { *next_++ = value ? 1 : 0; }

 private:
  char* next_;
};

class Counter {
 public:
  template <typename T>
  void operator()(const T& /*value*/) {
    size_ += sizeof(T);
  }
  std::size_t size() const { return size_; }

 private:
  std::size_t size_ = 0;
};

/// Precondition of each call: enough bytes are left.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}
  template <typename T>
  void operator()(T& value) {
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
  }
  void operator()(bool& value) {
    sound_ = sound_ && (bytes_.front() == 0 || bytes_.front() == 1);
    value = bytes_.front() == 1;
    bytes_.remove_prefix(1);
  }
  bool sound() const { return sound_; }

 private:
  std::string_view bytes_;
  bool sound_ = true;
};

template <typename Archive, typename P>
void visit_pose(Archive& archive, P& pose) {
  for (int i = 0; i < 3; ++i) archive(pose.p[i]);
  for (int i = 0; i < 4; ++i) archive(pose.q.coeffs()[i]);
}

template <typename Archive, typename O>
void visit_options(Archive& archive, O& options) {
  archive(options.seed);
  archive(options.jaw_friction);
  archive(options.scene_friction);
  archive(options.grip_torque_nm);
  archive(options.ticks_per_second);
}

template <typename Archive, typename M>
void visit_memory(Archive& archive, M& memory) {
  archive(memory.tick);
  archive(memory.strained);
  archive(memory.random);
  for (auto& arm : memory.arms) {
    visit_pose(archive, arm.setpoint.X_WT);
    archive(arm.setpoint.jaw_rad);
    archive(arm.setpoint_joints);
    visit_pose(archive, arm.X_WT);
    archive(arm.joints);
    archive(arm.jaws);
  }
  for (auto& block : memory.blocks) {
    archive(block.body);
    archive(block.rest_ticks);
    archive(block.asleep);
    archive(block.touches_scene);
    for (auto& arm : block.jaw_contact) {
      for (auto& touching : arm) archive(touching);
    }
  }
}

template <typename Archive>
void visit_header(Archive& archive, std::uint64_t& magic, std::uint32_t& version) {
  archive(magic);
  archive(version);
}

std::size_t header_size() {
  return sizeof kMagic + sizeof kVersion;
}

std::size_t total_size() {
  static const std::size_t size = [] {
    Counter counter;
    const WorldMemory memory;
    visit_memory(counter, memory);
    return memory_offset() + counter.size();
  }();
  return size;
}

bool plausible_pose(const spatial::Pose& pose) {
  return pose.finite() && pose.p.norm() < 10.0 && std::abs(pose.q.norm() - 1.0) < 1e-6;
}

Status check(const WorldMemory& memory) {
  const auto damaged = [] { return fail(ErrorCode::kInvalidArgument, "the snapshot is damaged"); };
  if (memory.tick < 0 || memory.strained < 0) return damaged();
  for (const kinematics::ArmSide side : kinematics::kArmSides) {
    const ArmMemory& arm = memory.arms[kinematics::index_of(side)];
    const kinematics::PsmModel model = kinematics::psm_model(side);
    if (!plausible_pose(arm.setpoint.X_WT) || !plausible_pose(arm.X_WT)) return damaged();
    if (!(arm.setpoint.jaw_rad >= model.jaw.low && arm.setpoint.jaw_rad <= model.jaw.high)) return damaged();
    if (!kinematics::check_limits(model, arm.joints)) return damaged();
    if (!kinematics::check_limits(model, arm.setpoint_joints)) return damaged();
    for (const BodyBits& jaw : arm.jaws) {
      if (!plausible(jaw) || (from_ode(jaw.position.data()) - arm.X_WT.p).norm() > kJawFromTip_m) return damaged();
    }
  }
  for (const BlockMemory& block : memory.blocks) {
    if (!plausible(block.body) || block.rest_ticks < 0) return damaged();
  }
  return {};
}

}  // namespace

std::size_t memory_offset() {
  static const std::size_t offset = [] {
    Counter counter;
    const WorldOptions options;
    visit_options(counter, options);
    return header_size() + counter.size();
  }();
  return offset;
}

std::string encode(const WorldOptions& options, const WorldMemory& memory) {
  std::string bytes(total_size(), '\0');
  Writer writer(bytes);
  std::uint64_t magic = kMagic;
  std::uint32_t version = kVersion;
  visit_header(writer, magic, version);
  visit_options(writer, options);
  visit_memory(writer, memory);
  return bytes;
}

Result<StoredWorld> decode(std::string_view bytes) {
  if (bytes.size() < header_size()) return fail(ErrorCode::kInvalidArgument, "the bytes are not a world's snapshot");
  Reader reader(bytes);
  std::uint64_t magic = 0;
  std::uint32_t version = 0;
  visit_header(reader, magic, version);
  if (magic != kMagic) return fail(ErrorCode::kInvalidArgument, "the bytes are not a world's snapshot");
  if (version != kVersion) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("the snapshot has version {}, this program reads version {}", version, kVersion));
  }
  if (bytes.size() != total_size()) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("the snapshot has {} bytes instead of {}", bytes.size(), total_size()));
  }
  StoredWorld stored;
  visit_options(reader, stored.options);
  visit_memory(reader, stored.memory);
  if (!reader.sound()) return fail(ErrorCode::kInvalidArgument, "the snapshot is damaged");
  TROCAR_RETURN_IF_ERROR(check(stored.memory));
  return stored;
}

}  // namespace trocar::simulation
