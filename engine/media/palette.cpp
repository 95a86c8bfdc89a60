#include "engine/media/palette.h"

#include <algorithm>
#include <array>

#include "engine/core/check.h"

namespace trocar::media {
namespace {

// Of each channel. A sixth gains a film 0.07 dB and costs it a quarter of its frames a second.
constexpr unsigned kBits = 5;
constexpr std::size_t kBins = std::size_t{1} << (3 * kBits);

std::size_t bin_of(Rgba c) {
  constexpr unsigned kDropped = 8 - kBits;
  return (static_cast<std::size_t>(c.r >> kDropped) << (2 * kBits)) |
         (static_cast<std::size_t>(c.g >> kDropped) << kBits) | static_cast<std::size_t>(c.b >> kDropped);
}

/// Pixels of nearly one colour.
struct Bin {
  std::size_t number = 0;
  double count = 0.0;
  std::array<double, 3> sum{};

  double mean(std::size_t channel) const { return sum[channel] / count; }
};

/// A part of the bins, and along which channel it is spread most.
struct Box {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::array<double, 3> mean{};
  std::size_t widest = 0;
  double spread = 0.0;  ///< Sum of squared distances from the mean along `widest`.
};

Box box_of(const std::vector<Bin>& bins, std::size_t begin, std::size_t end) {
  Box box{begin, end, {}, 0, 0.0};
  double count = 0.0;
  for (std::size_t i = begin; i < end; ++i) {
    count += bins[i].count;
    for (std::size_t c = 0; c < 3; ++c) box.mean[c] += bins[i].sum[c];
  }
  for (double& mean : box.mean) mean /= count;
  for (std::size_t c = 0; c < 3; ++c) {
    double spread = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const double apart = bins[i].mean(c) - box.mean[c];
      spread += bins[i].count * apart * apart;
    }
    // A single bin has none, whatever rounding makes of it.
    if (end - begin > 1 && spread > box.spread) {
      box.spread = spread;
      box.widest = c;
    }
  }
  return box;
}

std::vector<Bin> bins_of(std::span<const Rgba> pixels) {
  std::vector<Bin> all(kBins);
  for (const Rgba c : pixels) {
    Bin& bin = all[bin_of(c)];
    bin.count += 1.0;
    bin.sum[0] += c.r;
    bin.sum[1] += c.g;
    bin.sum[2] += c.b;
  }
  for (std::size_t i = 0; i < kBins; ++i) all[i].number = i;
  std::erase_if(all, [](const Bin& bin) { return bin.count == 0.0; });
  return all;
}

/// Cuts the box that is spread most at its mean, until there are `most`.
std::vector<Box> boxes_of(std::vector<Bin>& bins, std::size_t most) {
  std::vector<Box> boxes{box_of(bins, 0, bins.size())};
  while (boxes.size() < most) {
    const auto box =
        std::max_element(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.spread < b.spread; });
    if (box->spread == 0.0) break;
    const auto begin = bins.begin() + static_cast<std::ptrdiff_t>(box->begin);
    const auto end = bins.begin() + static_cast<std::ptrdiff_t>(box->end);
    const auto cut =
        std::partition(begin, end, [&](const Bin& bin) { return bin.mean(box->widest) < box->mean[box->widest]; });
    if (cut == begin || cut == end) {
      box->spread = 0.0;
      continue;
    }
    const auto at = static_cast<std::size_t>(cut - bins.begin());
    const Box upper = box_of(bins, at, box->end);
    *box = box_of(bins, box->begin, at);
    boxes.push_back(upper);
  }
  return boxes;
}

std::uint8_t rounded(double value) {
  return static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
}

}  // namespace

Palette palette_of(std::span<const Rgba> pixels, std::size_t most) {
  TROCAR_CHECK(most >= 1 && most <= 256);
  Palette palette;
  if (pixels.empty()) return palette;
  std::vector<Bin> bins = bins_of(pixels);
  std::vector<std::uint8_t> colour_of_bin(kBins);
  for (const Box& box : boxes_of(bins, most)) {
    const auto index = static_cast<std::uint8_t>(palette.colours.size());
    palette.colours.push_back({rounded(box.mean[0]), rounded(box.mean[1]), rounded(box.mean[2]), 255});
    for (std::size_t i = box.begin; i < box.end; ++i) colour_of_bin[bins[i].number] = index;
  }
  palette.indices.reserve(pixels.size());
  for (const Rgba c : pixels) palette.indices.push_back(colour_of_bin[bin_of(c)]);
  return palette;
}

}  // namespace trocar::media
