#include <doctest/doctest.h>

#include <array>
#include <thread>
#include <vector>

#include "tests/unit/simulation/transfer_motion.h"

using namespace trocar::simulation;
using trocar::ErrorCode;
using trocar::kinematics::ArmSide;

namespace {

/// The hash after every 50th tick of a transfer.
std::vector<std::uint64_t> hashes_of_transfer(std::uint64_t seed, int block, int goal) {
  World world({.seed = seed});
  std::vector<std::uint64_t> hashes;
  const auto status = transfer(world, block, goal, [&](World& stepped) {
    stepped.step();
    if (stepped.state().tick.count % 50 == 0) hashes.push_back(stepped.state_hash());
  });
  return status ? hashes : std::vector<std::uint64_t>{};
}

/// A transfer as commands: what each arm was told at each tick.
std::vector<std::array<ArmCommand, 2>> commands_of_transfer(int block, int goal) {
  World world;
  std::vector<std::array<ArmCommand, 2>> commands;
  const auto status = transfer(world, block, goal, [&](World& stepped) {
    commands.push_back({stepped.state().arms[0].setpoint, stepped.state().arms[1].setpoint});
    stepped.step();
  });
  return status ? commands : std::vector<std::array<ArmCommand, 2>>{};
}

void obey(World& world, const std::array<ArmCommand, 2>& commands) {
  REQUIRE(world.command(ArmSide::kLeft, commands[0]));
  REQUIRE(world.command(ArmSide::kRight, commands[1]));
  world.step();
}

}  // namespace

TEST_CASE("the same seed and commands give the same hashes, another seed others") {
  const auto first = hashes_of_transfer(3, 2, 1);
  REQUIRE(first.size() > 200);
  CHECK(first == hashes_of_transfer(3, 2, 1));
  CHECK(first.back() != hashes_of_transfer(4, 2, 1).back());
}

TEST_CASE("two worlds in two threads give the hashes that they give one after the other") {
  const auto left = hashes_of_transfer(5, 0, 3);
  const auto right = hashes_of_transfer(6, 3, 0);
  std::vector<std::uint64_t> left_threaded;
  std::vector<std::uint64_t> right_threaded;
  {
    const std::jthread a([&] { left_threaded = hashes_of_transfer(5, 0, 3); });
    const std::jthread b([&] { right_threaded = hashes_of_transfer(6, 3, 0); });
  }
  CHECK(left == left_threaded);
  CHECK(right == right_threaded);
}

TEST_CASE("a world that moves to another thread between steps goes on bit-identically") {
  const auto commands = commands_of_transfer(1, 4);
  REQUIRE(commands.size() > 4000);
  World stayed;
  World moved;
  for (std::size_t i = 0; i < 2500; ++i) obey(stayed, commands[i]);
  for (std::size_t i = 0; i < 2000; ++i) obey(moved, commands[i]);
  std::jthread([&] {
    for (std::size_t i = 2000; i < 2500; ++i) {
      if (!moved.command(ArmSide::kLeft, commands[i][0]) || !moved.command(ArmSide::kRight, commands[i][1])) return;
      moved.step();
    }
  }).join();
  CHECK(stayed.state_hash() == moved.state_hash());
}

TEST_CASE(
    "a restored world continues bit-identically from any moment of a transfer, in a fresh world and in a used one") {
  const auto commands = commands_of_transfer(1, 4);
  REQUIRE(commands.size() > 10000);
  World original;
  World used({.seed = 9});
  REQUIRE(transfer(used, 5, 5));
  struct Branch {
    std::size_t next;
    World world;
  };
  std::vector<Branch> branches;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (i % 1501 == 700) {  // in free motion, in the grip, at the hand-off, in the seat …
      const WorldSnapshot snapshot = original.snapshot();
      World fresh({.seed = 77});
      REQUIRE(fresh.restore(snapshot));
      CHECK(fresh.state_hash() == original.state_hash());
      CHECK(fresh.snapshot() == snapshot);
      branches.push_back({i, std::move(fresh)});
      REQUIRE(used.restore(snapshot));
    }
    obey(original, commands[i]);
    if (i >= 700) obey(used, commands[i]);
  }
  CHECK(used.state_hash() == original.state_hash());
  REQUIRE(branches.size() > 6);
  for (Branch& branch : branches) {
    for (std::size_t i = branch.next; i < commands.size(); ++i) obey(branch.world, commands[i]);
    CHECK(branch.world.state_hash() == original.state_hash());
  }
}

TEST_CASE("a snapshot between a command and its step keeps the command") {
  World world;
  ArmCommand command = world.state().arm(ArmSide::kLeft).setpoint;
  command.X_WT.p.z() += 1e-4;
  REQUIRE(world.command(ArmSide::kLeft, command));
  World other;
  REQUIRE(other.restore(world.snapshot()));
  world.step();
  other.step();
  CHECK(other.state().arm(ArmSide::kLeft).X_WT == command.X_WT);
  CHECK(world.state_hash() == other.state_hash());
}

TEST_CASE("bytes that are not a whole snapshot of such a world are refused and leave the world as it was") {
  World world;
  REQUIRE(take(world, ArmSide::kLeft, 1, 2));
  const std::uint64_t before = world.state_hash();
  const std::string good = world.snapshot().bytes;
  CHECK(good.size() < 2800);
  const auto refused = [&](const std::string& bytes) {
    const auto status = world.restore({bytes});
    return !status && status.error().code() == ErrorCode::kInvalidArgument && world.state_hash() == before;
  };
  CHECK(refused(""));
  CHECK(refused("not a snapshot at all"));
  CHECK(refused(good.substr(0, good.size() - 1)));
  CHECK(refused(good + "x"));
  std::string version = good;
  version[8] = static_cast<char>(version[8] + 1);
  CHECK(refused(version));
  std::string not_finite = good;
  for (std::size_t i = not_finite.size() - 300; i < not_finite.size() - 200; ++i) not_finite[i] = '\xff';
  CHECK(refused(not_finite));
  CHECK(world.restore({good}));
  CHECK(world.state_hash() == before);
}

TEST_CASE("a snapshot of a world with other physics is refused, one with another seed is not") {
  const World slippery({.jaw_friction = 0.15});
  const World half_rate({.ticks_per_second = 500});
  const World other_seed({.seed = 12});
  World world;
  CHECK_FALSE(world.restore(slippery.snapshot()));
  CHECK_FALSE(world.restore(half_rate.snapshot()));
  REQUIRE(world.restore(other_seed.snapshot()));
  CHECK(world.options().seed == 12);
  CHECK(world.state_hash() == other_seed.state_hash());
}

TEST_CASE("at 500 steps a second a tick of the clock is still a millisecond, and the transfer still works") {
  World world({.ticks_per_second = 500});
  world.step();
  CHECK(world.state().tick.count == 2);
  REQUIRE(transfer(world, 1, 4));
  CHECK(placed(world, 1, 4));
}
