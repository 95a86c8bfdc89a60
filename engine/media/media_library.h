/// Loads the library that holds OpenCV and FFmpeg, once, when it is first needed. Private to the module.
#pragma once

#include "engine/core/result.h"
#include "engine/media/plugin/media_api.h"

namespace trocar::media {

/// The table stays valid until the program ends. Threads: any.
/// Looked for in $TROCAR_PLUGINS, then in ../lib/trocar and ../lib beside the program's own folder.
/// Errors: kUnsupported with the reason.
Result<const trocar_media_api*> media_library();

}  // namespace trocar::media
