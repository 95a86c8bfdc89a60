/// Fields as numbers in files. Private to the module.
#pragma once

#include "engine/figure/field_figure.h"

namespace trocar::figure {

/// Numbers are the shortest text that reads back as the same number. Errors: kIo.
Status write_csv(const learning::Field& field, const std::optional<Slice>& slice, const std::filesystem::path& path);
/// NumPy's format 1.0, little-endian. Errors: kIo.
Status write_npy(const learning::Field& field, const std::optional<Slice>& slice, const std::filesystem::path& path);

/// VTK's XML ImageData: Float64 in base64 behind its length, x fastest, as VTK has it. Errors: kIo.
Status write_vti(const learning::Field& field, const std::filesystem::path& path);

}  // namespace trocar::figure
