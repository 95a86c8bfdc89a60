// Jobs of films from any bytes: what is accepted can be rendered as far as its numbers go, and reads back the same.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/film/composition_json.h"
#include "engine/film/frame_layout.h"
#include "engine/film/time_map.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar::film;
  const auto film = composition_from_json({reinterpret_cast<const char*>(data), size});
  if (!film) return 0;
  if (!check(*film)) __builtin_trap();
  const auto again = composition_from_json(to_json(*film));
  if (!again || to_json(*again) != to_json(*film)) __builtin_trap();
  for (const Cell& cell : cells_of(*film, film->width, film->height)) {
    if (cell.x < 0 || cell.y < 0 || cell.x + cell.width > film->width || cell.y + cell.height > film->height) {
      __builtin_trap();
    }
  }
  const auto map = TimeMap::create({{{0.0, 1.0}, 2.5}, {{0.0, 0.5}, 4.0}}, film->pace, film->fps);
  if (!map) return 0;
  for (const int frame : {0, map->frame_count() / 2, map->frame_count() - 1}) {
    for (const Instant& instant : map->at(frame).sources) {
      if (!(instant.at_s >= 0.0 && instant.at_s <= 4.0)) __builtin_trap();
    }
  }
  return 0;
}
