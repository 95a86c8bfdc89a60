/// A field over the lattice as an HDF5 file.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "engine/core/result.h"
#include "engine/learning/field.h"

namespace trocar::exchange {

/// One array of float64, n×n×n as [x][y][z], named as the layer ("value", "q+x" …), NaN where nothing is known. Beside
/// it the middles of the cells along each axis, "x_mm", "y_mm" and "z_mm", in W. Attributes of the array: "layer",
/// "title", "unit", "origin_mm" (the corner of the lattice with the smallest coordinates, in W), "cell_mm", "cells",
/// "axes", "categories" for classes, and `more` as texts. Errors: kUnsupported without the HDF5 process, kIo.
Status write_field_hdf5(const learning::Field& field, const std::map<std::string, std::string>& more,
                        const std::filesystem::path& path);

}  // namespace trocar::exchange
