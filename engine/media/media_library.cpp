#include "engine/media/media_library.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace trocar::media {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> folders() {
  std::vector<fs::path> out;
  if (const char* chosen = std::getenv("TROCAR_PLUGINS")) out.emplace_back(chosen);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path prefix = program.parent_path().parent_path();
  out.push_back(prefix / "lib" / "trocar");
  out.push_back(prefix / "lib");
  return out;
}

Result<const trocar_media_api*> load() {
  for (const fs::path& folder : folders()) {
    const fs::path path = folder / "trocar_media_codecs.so";
    std::error_code error;
    if (!fs::exists(path, error)) continue;
    // Never closed: threads of OpenCV may outlive every caller.
    void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
      return tl::unexpected(
          Error(ErrorCode::kUnsupported, std::string("could not load the media library (") + ::dlerror() + ")")
              .at(path.string()));
    }
    using Entry = const trocar_media_api* (*)();
    const auto entry = reinterpret_cast<Entry>(::dlsym(library, "trocar_media_api_2"));
    if (entry != nullptr) return entry();
    return tl::unexpected(
        Error(ErrorCode::kUnsupported, "the media library belongs to another version").at(path.string()));
  }
  return fail(ErrorCode::kUnsupported, "trocar_media_codecs.so is missing, so pictures and films cannot be written");
}

}  // namespace

Result<const trocar_media_api*> media_library() {
  static const Result<const trocar_media_api*> loaded = load();
  return loaded;
}

}  // namespace trocar::media
