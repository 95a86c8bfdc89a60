#include "engine/learning/model_codec.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "engine/learning/training_input.h"

namespace trocar::learning {
namespace {

static_assert(std::endian::native == std::endian::little, "files are little-endian");

constexpr std::string_view kMagic = "TRCMODEL";
constexpr std::uint32_t kTrainedFormat = 1;  // Programs that know of no imported models read these.

tl::unexpected<Error> corrupt(std::string what) {
  return fail(ErrorCode::kCorrupt, fmt::format("the model is damaged: {}", what));
}

class Writer {
 public:
  template <typename T>
  void number(T value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }

  /// Runs of equal bit patterns: length and value, until all are written.
  template <typename T>
  void runs(const std::vector<T>& values) {
    number(static_cast<std::uint64_t>(values.size()));
    for (std::size_t i = 0; i < values.size();) {
      std::size_t end = i + 1;
      // Bits, not numbers: -0 is not 0 here, and a NaN equals itself.
      // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
      while (end < values.size() && std::memcmp(&values[end], &values[i], sizeof(T)) == 0) ++end;
      number(static_cast<std::uint32_t>(end - i));
      number(values[i]);
      i = end;
    }
  }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Remembers that it ran out, so that only the ends need a check.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  T number() {
    T value{};
    if (bytes_.size() < sizeof(T)) {
      good_ = false;
      bytes_ = {};
      return value;
    }
    std::memcpy(&value, bytes_.data(), sizeof(T));
    bytes_.remove_prefix(sizeof(T));
    return value;
  }

  template <typename T>
  std::vector<T> runs(std::size_t expected) {
    std::vector<T> values;
    if (number<std::uint64_t>() != expected) good_ = false;
    while (good_ && values.size() < expected) {
      const auto length = number<std::uint32_t>();
      const T value = number<T>();
      if (length == 0 || length > expected - values.size()) good_ = false;
      if (good_) values.insert(values.end(), length, value);
    }
    return values;
  }

  bool good() const { return good_; }
  bool at_end() const { return good_ && bytes_.empty(); }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
  bool good_ = true;
};

void write_options(Writer& writer, const TrainOptions& o) {
  writer.number(o.method);
  for (const double value : {o.theta_rate, o.q_rate, o.discount, o.epsilon}) writer.number(value);
  writer.number(static_cast<std::int32_t>(o.episodes));
  writer.number(o.seed);
  writer.number(static_cast<std::int32_t>(o.safe_radius));
  writer.number(static_cast<std::int32_t>(o.start_spread));
  writer.number(o.theta_prior);
  writer.number(o.regularisation);
}

TrainOptions read_options(Reader& reader) {
  TrainOptions o;
  o.method = static_cast<Method>(reader.number<std::uint8_t>());
  for (double* value : {&o.theta_rate, &o.q_rate, &o.discount, &o.epsilon}) *value = reader.number<double>();
  o.episodes = reader.number<std::int32_t>();
  o.seed = reader.number<std::uint64_t>();
  o.safe_radius = reader.number<std::int32_t>();
  o.start_spread = reader.number<std::int32_t>();
  o.theta_prior = reader.number<double>();
  o.regularisation = reader.number<double>();
  return o;
}

void write_sequences(Writer& writer, const std::vector<CellSequence>& experts) {
  writer.number(static_cast<std::uint32_t>(experts.size()));
  for (const CellSequence& cells : experts) {
    writer.number(static_cast<std::uint32_t>(cells.size()));
    for (const spatial::CellIndex cell : cells) writer.number(cell.value);
  }
}

std::vector<CellSequence> read_sequences(Reader& reader) {
  std::vector<CellSequence> experts;
  const auto count = reader.number<std::uint32_t>();
  for (std::uint32_t i = 0; i < count && reader.good(); ++i) {
    const auto length = reader.number<std::uint32_t>();
    CellSequence cells;
    for (std::uint32_t k = 0; k < length && reader.good(); ++k) cells.push_back({reader.number<std::int32_t>()});
    experts.push_back(std::move(cells));
  }
  return experts;
}

void read_arrays(Reader& reader, Model& model) {
  const auto cells = static_cast<std::size_t>(model.grid.cell_count());
  const auto safe = reader.runs<std::uint8_t>(cells);
  model.safe = spatial::CellSet(model.grid);
  for (std::size_t s = 0; s < safe.size(); ++s) {
    if (safe[s] != 0) model.safe.insert({static_cast<std::int32_t>(s)});
  }
  model.theta = reader.runs<double>(cells);
  model.q = reader.runs<double>(cells * spatial::kActionCount);
  model.value = reader.runs<double>(cells);
  model.visits = reader.runs<std::uint32_t>(cells);
  model.tried = reader.runs<std::uint8_t>(cells);
  const auto epochs = reader.number<std::uint32_t>();
  for (std::uint32_t i = 0; i < epochs && reader.good(); ++i) model.curve.push_back(reader.number<double>());
  model.seconds = reader.number<double>();
}

Result<Model> read_body(Reader& reader) {
  const TrainOptions options = read_options(reader);
  spatial::Grid grid;
  for (int i = 0; i < 3; ++i) grid.p_WGo[i] = reader.number<double>();
  grid.cell_m = reader.number<double>();
  grid.n = reader.number<std::int32_t>();
  const std::vector<CellSequence> experts = read_sequences(reader);
  if (!reader.good()) return corrupt("it ends too early");
  if (options.method > Method::kImported) return corrupt("its method is unknown");
  if (Status checked = check_training(grid, experts, options); !checked) {
    return corrupt(checked.error().text());
  }
  Model model;
  model.options = options;
  model.grid = grid;
  model.experts = experts;
  model.start = experts.front().front();
  model.goal = experts.front().back();
  read_arrays(reader, model);
  const auto hash = reader.number<std::uint64_t>();
  if (!reader.at_end()) return corrupt("its length does not fit its content");
  if (hash != model.hash()) return corrupt("its hash does not fit its content");
  return model;
}

}  // namespace

std::string encode_model(const Model& model) {
  Writer body;
  write_options(body, model.options);
  for (int i = 0; i < 3; ++i) body.number(model.grid.p_WGo[i]);
  body.number(model.grid.cell_m);
  body.number(static_cast<std::int32_t>(model.grid.n));
  write_sequences(body, model.experts);
  body.runs(model.safe.flags());
  body.runs(model.theta);
  body.runs(model.q);
  body.runs(model.value);
  body.runs(model.visits);
  body.runs(model.tried);
  body.number(static_cast<std::uint32_t>(model.curve.size()));
  for (const double mismatch : model.curve) body.number(mismatch);
  body.number(model.seconds);
  body.number(model.hash());
  const std::string content = body.take();
  Writer head;
  head.number(model.options.method == Method::kImported ? kModelFormat : kTrainedFormat);
  head.number(static_cast<std::uint64_t>(content.size()));
  return std::string(kMagic) + head.take() + content;
}

Result<Model> decode_model(std::string_view bytes) {
  if (bytes.substr(0, kMagic.size()) != kMagic) return corrupt("it is no model");
  Reader reader(bytes.substr(kMagic.size()));
  const auto format = reader.number<std::uint32_t>();
  const auto length = reader.number<std::uint64_t>();
  if (!reader.good()) return corrupt("it ends too early");
  if (format > kModelFormat) {
    return fail(ErrorCode::kUnsupported,
                fmt::format("the model has format {}, but this program reads up to {}", format, kModelFormat));
  }
  if (format == 0 || length != reader.left()) return corrupt("its length does not fit its content");
  return read_body(reader);
}

}  // namespace trocar::learning
