/// A demonstration as a NumPy array file: float64, one row for each sample, the columns of `columns()` in their order.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/exchange/imported.h"

namespace trocar::exchange {

/// Format version 1.0, little-endian, C order.
std::string to_npy(const demonstration::Demonstration& document);
/// What comes before the rows of such an array, and one of them.
std::string npy_head(std::size_t rows);
void add_npy_row(const demonstration::Sample& sample, std::string& bytes);

/// Errors: kCorrupt for what is not such an array or has another number of columns, naming the row at fault;
/// kUnsupported for another type of number or Fortran order.
Result<Imported> from_npy(std::string_view bytes);

/// The same from a file, which is not held in memory; also kIo.
Result<Imported> read_npy(const std::filesystem::path& path);
/// Whether an array that begins so has as many columns as a demonstration. Errors: kCorrupt for what is no array.
Result<bool> is_demonstration_npy(std::string_view beginning);

/// Any array of numbers: real or whole, of 4 or 8 bytes, little-endian, in C or in Fortran order.
struct NpyNumbers {
  std::vector<std::size_t> shape;
  std::vector<double> values;  ///< In C order: the last index runs fastest.
};
/// The shape alone, before anything is made of its size. Errors: kCorrupt.
Result<std::vector<std::size_t>> read_npy_shape(std::string_view bytes);
/// Errors: kCorrupt, also for numbers that do not fit the shape; kUnsupported.
Result<NpyNumbers> read_npy_numbers(std::string_view bytes);
/// Little-endian float64 in C order. Precondition: the numbers fit the shape.
std::string to_npy(const NpyNumbers& numbers);

/// Any array of two dimensions.
struct NpyArray {
  std::size_t width = 1;
  std::vector<double> values;  ///< By rows.
};
/// Errors: kCorrupt, kUnsupported.
Result<NpyArray> read_npy_array(std::string_view bytes);

}  // namespace trocar::exchange
