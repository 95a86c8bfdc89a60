#include "engine/workbench/jobs/film_sink.h"

#include <fmt/format.h>

#include <cctype>
#include <optional>
#include <utility>
#include <vector>

#include "engine/core/file.h"
#include "engine/media/picture_file.h"

namespace trocar::workbench {
namespace {

namespace fs = std::filesystem;

class FileSink final : public FilmSink {
 public:
  explicit FileSink(media::VideoWriter writer) : writer_(std::move(writer)) {}
  Status add(Image frame) override { return writer_.add(std::move(frame)); }
  Status finish() override { return writer_.finish(); }
  std::string codec() const override { return std::string(media::to_string(writer_.codec())); }

 private:
  media::VideoWriter writer_;
};

/// "F_", 5 and ".png" of "F_%05d.png".
struct RowName {
  std::string before;
  int digits = 0;
  std::string after;
};

std::optional<RowName> row_name(const fs::path& path) {
  const std::string name = path.filename().string();
  const std::size_t percent = name.find('%');
  if (path.extension() != ".png" || percent == std::string::npos) return std::nullopt;
  std::size_t at = percent + 1;
  int digits = 0;
  while (at < name.size() && std::isdigit(static_cast<unsigned char>(name[at])) != 0 && digits < 10) {
    digits = 10 * digits + (name[at++] - '0');
  }
  if (at >= name.size() || name[at] != 'd' || digits > 9) return std::nullopt;
  return RowName{name.substr(0, percent), digits, name.substr(at + 1)};
}

/// Each picture has another name until all are there.
class PictureSink final : public FilmSink {
 public:
  PictureSink(fs::path folder, RowName name) : folder_(std::move(folder)), name_(std::move(name)) {}
  ~PictureSink() override {
    std::error_code ignored;
    for (const auto& [temporary, target] : written_) fs::remove(temporary, ignored);
  }

  Status add(Image frame) override {
    const fs::path target =
        folder_ / fmt::format("{}{:0{}}{}", name_.before, written_.size(), name_.digits, name_.after);
    TROCAR_ASSIGN_OR_RETURN(fs::path file, replaceable_file(target));
    written_.emplace_back(temporary_beside(file), file);
    return media::write_png(written_.back().first, frame);
  }
  Status finish() override {
    for (const auto& [temporary, target] : written_) {
      std::error_code error;
      fs::rename(temporary, target, error);
      if (error) {
        return tl::unexpected(Error(ErrorCode::kIo, "could not put the picture in place").at(target.string()));
      }
    }
    written_.clear();
    return {};
  }
  std::string codec() const override { return "png"; }

 private:
  fs::path folder_;
  RowName name_;
  std::vector<std::pair<fs::path, fs::path>> written_;
};

}  // namespace

bool is_picture_row(const fs::path& path) {
  return row_name(path).has_value();
}

Status check_film_sink(const fs::path& path, const media::VideoOptions& options, const media::VideoDetails& details) {
  if (!is_picture_row(path)) return media::check_video(path, options, details);
  if (options.codec != media::Codec::kAuto) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("pictures are not in {}: leave the codec out", media::to_string(options.codec)));
  }
  if (details.crf) return fail(ErrorCode::kInvalidArgument, "pictures lose nothing: leave the crf out");
  return {};
}

Result<std::unique_ptr<FilmSink>> open_film_sink(const fs::path& path, const media::VideoOptions& options,
                                                 const media::VideoDetails& details) {
  TROCAR_RETURN_IF_ERROR(check_film_sink(path, options, details));
  if (const std::optional<RowName> name = row_name(path)) {
    return std::unique_ptr<FilmSink>(std::make_unique<PictureSink>(path.parent_path(), *name));
  }
  TROCAR_ASSIGN_OR_RETURN(media::VideoWriter writer, media::VideoWriter::open(path, options, details));
  return std::unique_ptr<FilmSink>(std::make_unique<FileSink>(std::move(writer)));
}

fs::path subtitles_beside(const fs::path& path, std::string_view ending) {
  if (const std::optional<RowName> name = row_name(path)) {
    std::string stem = name->before;
    while (!stem.empty() && (stem.back() == '_' || stem.back() == '-' || stem.back() == '.')) stem.pop_back();
    return path.parent_path() / ((stem.empty() ? "film" : stem) + std::string(ending));
  }
  return fs::path(path).replace_extension(ending);
}

}  // namespace trocar::workbench
