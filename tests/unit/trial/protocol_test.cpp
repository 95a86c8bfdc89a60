// Protocols: the paper's two ship and read, the order is balanced, blocks end, and what makes no sense is refused.
#include "engine/trial/protocol.h"

#include <doctest/doctest.h>

using namespace trocar;
using namespace trocar::trial;

TEST_CASE("the paper's protocols ship, and go to JSON and back") {
  const Protocol sim = find_protocol("sim").value();
  REQUIRE(sim.blocks.size() == 6);
  CHECK(sim.fixed == 2);
  CHECK_FALSE(sim.blocks[0].counts);
  for (const ProtocolBlock& block : sim.blocks) CHECK(block.time_s == 300.0);
  const Protocol dvrk = find_protocol("dvrk").value();
  REQUIRE(dvrk.blocks.size() == 2);
  CHECK(dvrk.blocks[0].successes == 10);
  CHECK(to_json(protocol_from_json(to_json(sim)).value()) == to_json(sim));
  CHECK(find_protocol("/nowhere/p.json").error().code() == ErrorCode::kIo);
}

TEST_CASE("in every pair of subjects one begins with either mode, familiarisation first for both") {
  const Protocol sim = find_protocol("sim").value();
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    for (int subject = 0; subject < 12; subject += 2) {
      const auto first = order_for(sim, subject, seed);
      const auto second = order_for(sim, subject + 1, seed);
      CHECK(first[0].name == sim.blocks[0].name);
      CHECK(first[1].name == sim.blocks[1].name);
      CHECK(first[2].mode != second[2].mode);
      CHECK(first[2].mode == first[3].mode);
      CHECK(first.size() == sim.blocks.size());
    }
  }
}

TEST_CASE("a block is over after its time, its transfers or its successes") {
  ProtocolBlock block;
  block.time_s = 60.0;
  block.successes = 3;
  CHECK_FALSE(block_over(block, 10, 2, 59.9));
  CHECK(block_over(block, 10, 3, 1.0));
  CHECK(block_over(block, 0, 0, 60.0));
}

TEST_CASE("what makes no sense is refused with its member") {
  const auto why = [](const char* text) { return protocol_from_json(text).error().text(); };
  CHECK(why("[]").find("object") != std::string::npos);
  CHECK(why("{}").find("blocks") != std::string::npos);
  CHECK(why(R"({"blocks":[{"mode":"MT"}]})").find("never end") != std::string::npos);
  CHECK(why(R"({"blocks":[{"mode":"XX","transfers":1}]})").find("XX") != std::string::npos);
  CHECK(why(R"({"blocks":[{"mode":"MT","transfers":1.5}]})").find("whole") != std::string::npos);
  CHECK(why(R"({"blocks":[{"mode":"MT","time_s":"long"}]})").find("time_s") != std::string::npos);
}
