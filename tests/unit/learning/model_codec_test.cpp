#include "engine/learning/model_codec.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstring>

#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

Model small_model(Method method) {
  TrainOptions options;
  options.method = method;
  options.episodes = 50;
  const spatial::Grid grid = spatial::Grid::with_cells(6);
  Progress progress;
  return train(grid, {testing::approach_from_above(grid, {0, 0, 5}, {4, 3, 1}, 3, 1)}, options, progress).value();
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

TEST_CASE("a model of every method comes back equal bit for bit") {
  for (const Method method : {Method::kEgMaxent, Method::kEgMaxentPlus, Method::kExact}) {
    const Model model = small_model(method);
    const Model back = decode_model(encode_model(model)).value();
    CHECK(back.hash() == model.hash());
    CHECK(same_bits(back.q, model.q));
    CHECK(back.safe == model.safe);
    CHECK(back.goal == model.goal);
    CHECK(back.seconds == model.seconds);
  }
}

TEST_CASE("a model cut short at any byte is refused as corrupt") {
  const std::string bytes = encode_model(small_model(Method::kEgMaxentPlus));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const auto model = decode_model(std::string_view(bytes).substr(0, length));
    REQUIRE_FALSE(model.has_value());
    REQUIRE(model.error().code() == ErrorCode::kCorrupt);
  }
  CHECK_FALSE(decode_model(bytes + "x").has_value());
}

TEST_CASE("a model with one changed byte is refused") {
  const std::string bytes = encode_model(small_model(Method::kExact));
  const auto seconds_at = bytes.size() - 16;  // the training time is not part of the hash
  CHECK(rc::check([&] {
    const auto at = *rc::gen::inRange<std::size_t>(0, bytes.size());
    RC_PRE(at < seconds_at || at >= seconds_at + 8);
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ *rc::gen::inRange(1, 256));
    RC_ASSERT(!decode_model(changed).has_value());
  }));
}

TEST_CASE("a file of another kind is corrupt, a newer format unsupported") {
  CHECK(decode_model("SQLite format 3").error().code() == ErrorCode::kCorrupt);
  CHECK(decode_model("").error().code() == ErrorCode::kCorrupt);
  std::string newer = encode_model(small_model(Method::kEgMaxent));
  newer[8] = static_cast<char>(kModelFormat + 1);
  CHECK(decode_model(newer).error().code() == ErrorCode::kUnsupported);
}
