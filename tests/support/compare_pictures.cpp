// compare_pictures PICTURE GOLDEN: 0 if they are alike, 1 with how far they are apart, 3 if one cannot be read.
// For tests that are no C++; the comparison is that of golden_windows.
#include <fmt/format.h>

#include "tests/support/golden_picture.h"

int main(int count, char** words) {
  using namespace trocar;
  if (count != 3) {
    fmt::print(stderr, "compare_pictures PICTURE GOLDEN\n");
    return 2;
  }
  const Result<Image> image = media::read_picture(words[1]);
  const Result<ImageDifference> apart =
      image ? testing::golden_difference(*image, words[2]) : tl::unexpected(image.error());
  if (!apart) {
    fmt::print(stderr, "{}\n", apart.error().text());
    return 3;
  }
  if (testing::alike(*apart)) return 0;
  fmt::print("{} differs from {}: {:.2f} on average, {} at worst\n", words[1], words[2], apart->mean, apart->worst);
  return 1;
}
