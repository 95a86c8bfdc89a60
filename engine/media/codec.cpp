#include "engine/media/codec.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "engine/core/check.h"
#include "engine/media/media_library.h"

namespace trocar::media {
namespace {

struct CodecRow {
  Codec codec;
  std::string_view name;
  const char* encoder;
  std::vector<std::string_view> extensions;  ///< The first one is usual.
  bool automatic;                            ///< Tried for kAuto, in this order.
  Crf crf;
};

const std::array<CodecRow, 7>& rows() {
  static const std::array<CodecRow, 7> table{{
      {Codec::kH264, "h264", "libx264", {".mp4", ".mov", ".mkv"}, true, {20, 51}},
      {Codec::kMpeg4, "mpeg4", "mpeg4", {".mp4", ".mov", ".mkv", ".avi"}, true, {}},
      {Codec::kMotionJpeg, "mjpeg", "mjpeg", {".avi", ".mkv", ".mov"}, true, {}},
      {Codec::kFfv1, "ffv1", "ffv1", {".mkv", ".avi"}, false, {}},
      {Codec::kVp9, "vp9", "libvpx-vp9", {".webm", ".mkv"}, true, {30, 63}},
      {Codec::kAv1, "av1", "libsvtav1", {".mp4", ".webm", ".mkv"}, false, {32, 63}},
      {Codec::kGif, "gif", "", {".gif"}, true, {}},
  }};
  return table;
}

bool fits(const CodecRow& row, std::string_view extension) {
  return std::find(row.extensions.begin(), row.extensions.end(), extension) != row.extensions.end();
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

template <typename Words>
std::string either(const Words& words) {
  const std::vector<std::string_view> all(words.begin(), words.end());
  const std::string first = fmt::format("{}", fmt::join(all.begin(), all.end() - 1, ", "));
  return first.empty() ? std::string(all.back()) : fmt::format("{} or {}", first, all.back());
}

std::string all_endings() {
  std::vector<std::string_view> endings;
  for (const CodecRow& row : rows()) {
    for (const std::string_view ending : row.extensions) {
      if (std::find(endings.begin(), endings.end(), ending) == endings.end()) endings.push_back(ending);
    }
  }
  return either(endings);
}

/// Writes a few small frames where temporary files go.
bool works(const trocar_media_api& api, const CodecRow& row) {
  if (row.codec == Codec::kGif) return true;  // giflib is linked.
  std::error_code error;
  const std::filesystem::path path = std::filesystem::temp_directory_path(error) /
                                     fmt::format("trocar_codec_{}_{}{}", ::getpid(), row.name, row.extensions.front());
  if (error) return false;
  const trocar_film_format format{row.encoder, 30.0, 64, 64, row.crf.usual, "", ""};
  void* writer = api.writer_open(path.c_str(), &format);
  bool good = writer != nullptr;
  if (good) {
    const Image grey(64, 64, {90, 90, 90, 255});
    for (int i = 0; i < 3; ++i) good = api.writer_add(writer, grey.rgba.data()) != 0 && good;
    good = api.writer_close(writer) != 0 && good;
    const auto size = std::filesystem::file_size(path, error);
    good = good && !error && size > 0;
  }
  std::filesystem::remove(path, error);
  return good;
}

}  // namespace

std::string_view to_string(Codec codec) {
  for (const CodecRow& row : rows()) {
    if (row.codec == codec) return row.name;
  }
  return "auto";
}

Result<Codec> codec_from(std::string_view text) {
  if (text == "auto") return Codec::kAuto;
  for (const CodecRow& row : rows()) {
    if (row.name == text) return row.codec;
  }
  std::string known = "auto";
  for (const CodecRow& row : rows()) known += fmt::format(", {}", row.name);
  return fail(ErrorCode::kInvalidArgument, fmt::format("no codec is named \"{}\"; there are {}", text, known));
}

std::string_view usual_ending(Codec codec) {
  for (const CodecRow& row : rows()) {
    if (row.codec == codec) return row.extensions.front();
  }
  return rows().front().extensions.front();
}

std::vector<Codec> all_codecs() {
  std::vector<Codec> out;
  for (const CodecRow& row : rows()) out.push_back(row.codec);
  return out;
}

std::vector<Codec> available_codecs() {
  std::vector<Codec> out;
  const Result<const trocar_media_api*> api = media_library();
  if (!api) return out;
  for (const CodecRow& row : rows()) {
    if (works(**api, row)) out.push_back(row.codec);
  }
  return out;
}

Result<std::vector<Codec>> codecs_for(const std::filesystem::path& path, Codec wanted) {
  const std::string extension = lower(path.extension().string());
  std::vector<Codec> out;
  for (const CodecRow& row : rows()) {
    const bool asked = wanted == Codec::kAuto ? row.automatic : wanted == row.codec;
    if (asked && fits(row, extension)) out.push_back(row.codec);
  }
  if (!out.empty()) return out;
  std::string sentence = "a film's name ends in " + all_endings();
  for (const CodecRow& row : rows()) {
    if (row.codec == wanted) {
      sentence = fmt::format("a film in {} ends in {}", row.name, either(row.extensions));
    }
  }
  return tl::unexpected(Error(ErrorCode::kInvalidArgument, sentence).at(path.string()));
}

Crf crf_of(Codec codec) {
  for (const CodecRow& row : rows()) {
    if (row.codec == codec) return row.crf;
  }
  return {};
}

Result<Codec> codec_for(const std::filesystem::path& path, Codec wanted) {
  TROCAR_ASSIGN_OR_RETURN(const std::vector<Codec> codecs, codecs_for(path, wanted));
  return codecs.front();
}

const char* encoder_of(Codec codec) {
  for (const CodecRow& row : rows()) {
    if (row.codec == codec) return row.encoder;
  }
  TROCAR_CHECK(codec != Codec::kAuto);
  return "";
}

bool declares_frames(const std::filesystem::path& path) {
  const std::string extension = lower(path.extension().string());
  return extension != ".mkv" && extension != ".webm";
}

}  // namespace trocar::media
