#include "engine/exchange/row_reader.h"

#include <utility>

namespace trocar::exchange {

Status RowReader::add(const std::vector<double>& values) {
  demonstration::Sample sample;
  TROCAR_RETURN_IF_ERROR(sample_from_row(order_, values, sample));
  std::vector<demonstration::Sample>& samples = imported_.recording.samples;
  if (!samples.empty() && sample.tick <= samples.back().tick) {
    return fail(ErrorCode::kInvalidArgument, "t_s must be at least a millisecond after that of the row before");
  }
  if (!demonstration::is_finite(sample)) {
    return fail(ErrorCode::kInvalidArgument, "a value is too large for single precision");
  }
  samples.push_back(sample);
  return {};
}

Result<Imported> RowReader::finish() {
  if (imported_.recording.samples.size() < 2) {
    return fail(ErrorCode::kCorrupt, "a demonstration needs at least 2 rows of samples");
  }
  TROCAR_RETURN_IF_ERROR(demonstration::check_samples(imported_.recording.samples));
  imported_.recording.provenance.operator_kind = "imported";
  imported_.recording.provenance.block = demonstration::kUnknownPlace;
  imported_.recording.provenance.goal = demonstration::kUnknownPlace;
  imported_.recording.outcome = demonstration::Outcome::kUnknown;
  imported_.lossy = lost_by_import(order_);
  return std::move(imported_);
}

}  // namespace trocar::exchange
