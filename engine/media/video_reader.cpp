#include <fmt/format.h>

#include <memory>

#include "engine/media/media_library.h"
#include "engine/media/video_writer.h"

namespace trocar::media {
namespace {

/// An open film; closes itself.
struct OpenFilm {
  const trocar_media_api* api = nullptr;
  std::unique_ptr<void, void (*)(void*)> handle{nullptr, nullptr};
  VideoInfo info;
};

Result<OpenFilm> open_film(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    return tl::unexpected(Error(ErrorCode::kIo, "there is no such file").at(path.string()));
  }
  OpenFilm film;
  TROCAR_ASSIGN_OR_RETURN(film.api, media_library());
  film.handle = {film.api->reader_open(path.c_str()), film.api->reader_close};
  if (!film.handle) return tl::unexpected(Error(ErrorCode::kCorrupt, "the file is no film").at(path.string()));
  double declared = 0.0;
  film.api->reader_info(film.handle.get(), &film.info.width, &film.info.height, &film.info.fps, &declared);
  if (film.info.width < 1 || film.info.height < 1) {
    return tl::unexpected(Error(ErrorCode::kCorrupt, "the film has no picture size").at(path.string()));
  }
  return film;
}

}  // namespace

Result<VideoInfo> probe_video(const std::filesystem::path& path) {
  TROCAR_ASSIGN_OR_RETURN(OpenFilm film, open_film(path));
  while (film.api->reader_next(film.handle.get()) != 0) ++film.info.frames;
  if (film.info.frames == 0) return tl::unexpected(Error(ErrorCode::kCorrupt, "the film is empty").at(path.string()));
  return film.info;
}

Result<Image> read_video_frame(const std::filesystem::path& path, int index) {
  if (index < 0) return fail(ErrorCode::kInvalidArgument, "frames count from 0");
  TROCAR_ASSIGN_OR_RETURN(const OpenFilm film, open_film(path));
  for (int i = 0; i <= index; ++i) {
    if (film.api->reader_next(film.handle.get()) != 0) continue;
    return tl::unexpected(
        Error(ErrorCode::kNotFound, fmt::format("the film has {} frames, and none numbered {}", i, index))
            .at(path.string()));
  }
  Image image(film.info.width, film.info.height);
  if (film.api->reader_picture(film.handle.get(), image.rgba.data()) == 0) {
    return tl::unexpected(
        Error(ErrorCode::kCorrupt, fmt::format("frame {} cannot be decoded", index)).at(path.string()));
  }
  return image;
}

}  // namespace trocar::media
