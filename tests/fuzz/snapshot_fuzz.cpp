// Snapshots come out of project files: whatever bytes they hold, a world takes them whole or stays as it was, and
// steps.
#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/core/check.h"
#include "engine/simulation/world.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static trocar::simulation::World world;
  const std::uint64_t before = world.state_hash();
  const trocar::simulation::WorldSnapshot snapshot{std::string(reinterpret_cast<const char*>(data), size)};
  if (!world.restore(snapshot)) {
    TROCAR_CHECK(world.state_hash() == before);
    return 0;
  }
  for (int i = 0; i < 20; ++i) world.step();
  for (const auto& block : world.state().blocks) TROCAR_CHECK(block.X_WK.finite());
  return 0;
}
