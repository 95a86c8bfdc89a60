// Learning curves against those that were looked at and found right: training is the same to the bit on every machine
// (portable_math.h), so these are, too, but for the decimals they are written with.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "engine/core/file.h"
#include "engine/learning/model.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

TEST_CASE("the learning curve of every method is the golden one") {
  for (const Method method : {Method::kEgMaxent, Method::kEgMaxentPlus, Method::kExact}) {
    CAPTURE(to_string(method));
    TrainOptions options;
    options.method = method;
    options.seed = 7;
    Progress progress;
    const Model model = train(spatial::Grid{}, {testing::sample_demonstrations()[2]}, options, progress).value();
    REQUIRE(model.curve.size() > 5);
    std::string text = "epoch,mismatch\n";
    for (std::size_t i = 0; i < model.curve.size(); ++i) text += fmt::format("{},{:.9g}\n", i + 1, model.curve[i]);
    const std::filesystem::path path = share_path("tests/golden/curves") / fmt::format("{}.csv", to_string(method));
    if (std::getenv("TROCAR_BLESS") != nullptr) REQUIRE(write_file(path, text));
    CHECK(text == read_file(path).value());
  }
}
