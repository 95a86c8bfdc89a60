#include "engine/exchange/field_hdf5.h"

#include <cmath>

#include "engine/core/file.h"
#include "engine/exchange/hdf5_process.h"
#include "engine/exchange/new_file.h"
#include "engine/spatial/units.h"

namespace trocar::exchange {
namespace {

using Kind = TreeNode::Kind;

/// Picometres away from a multiple of a nanometre are rounding, not position.
double tidy_mm(double metres) {
  return std::round(spatial::to_mm(metres) * 1e6) / 1e6;
}

TreeNode field_node(const learning::Field& field, const std::map<std::string, std::string>& more) {
  const spatial::Grid& grid = field.grid;
  const auto n = static_cast<std::uint64_t>(grid.n);
  TreeNode node = array_node(std::string(learning::to_string(field.layer)), Kind::kFloat64, {n, n, n}, field.values);
  for (const auto& [name, text] : more) node.attributes[name] = text;
  node.attributes["layer"] = std::string(learning::to_string(field.layer));
  node.attributes["title"] = field.title;
  node.attributes["unit"] = field.unit;
  node.attributes["origin_mm"] =
      std::vector<double>{tidy_mm(grid.p_WGo.x()), tidy_mm(grid.p_WGo.y()), tidy_mm(grid.p_WGo.z())};
  node.attributes["cell_mm"] = tidy_mm(grid.cell_m);
  node.attributes["cells"] = static_cast<std::int64_t>(grid.n);
  node.attributes["axes"] = std::vector<std::string>{"x", "y", "z"};
  if (field.categorical) node.attributes["categories"] = field.categories;
  return node;
}

TreeNode axis_node(const spatial::Grid& grid, int axis) {
  std::vector<double> middles;
  for (int i = 0; i < grid.n; ++i) middles.push_back(tidy_mm(grid.p_WGo[axis] + (i + 0.5) * grid.cell_m));
  return array_node(std::string(1, "xyz"[axis]) + "_mm", Kind::kFloat64, {middles.size()}, middles);
}

Status write_arrays(const learning::Field& field, const std::map<std::string, std::string>& more,
                    const std::filesystem::path& path) {
  TROCAR_ASSIGN_OR_RETURN(const std::filesystem::path target, replaceable_file(path));
  NewFile file(target);
  TROCAR_ASSIGN_OR_RETURN(Hdf5Writer writer, Hdf5Writer::create(file.path()));
  TROCAR_RETURN_IF_ERROR(writer.add(field_node(field, more)));
  for (int axis = 0; axis < 3; ++axis) TROCAR_RETURN_IF_ERROR(writer.add(axis_node(field.grid, axis)));
  TROCAR_RETURN_IF_ERROR(writer.finish());
  return file.put_in_place();
}

}  // namespace

Status write_field_hdf5(const learning::Field& field, const std::map<std::string, std::string>& more,
                        const std::filesystem::path& path) {
  Status written = write_arrays(field, more, path);
  if (!written) return tl::unexpected(std::move(written).error().at(path.string()));
  return {};
}

}  // namespace trocar::exchange
