/// The one program that links HDF5: `trocar-hdf5 read|write FILE`, tree nodes on the socket that is its standard input
/// and output. Started by `hdf5_process.h`. Of a process of its own a broken file can only break that, and no start of
/// another program pays for HDF5's libraries.
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>

#include "engine/exchange/plugin/hdf5_file.h"
#include "engine/exchange/tree_stream.h"

namespace {

using namespace trocar;
using namespace trocar::exchange;

constexpr int kSocket = STDIN_FILENO;

// Sanitizers reserve more addresses than there is memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kSanitized = false;
#endif

void set_limit(int resource, rlim_t value) {
  const rlimit limit{value, value};
  ::setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

/// A file may neither run on for ever, nor eat all memory, nor leave a core.
void set_limits() {
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_CPU, 600);
  if (!kSanitized) set_limit(RLIMIT_AS, rlim_t{6} << 30);
}

Status write(const std::string& path) {
  TROCAR_ASSIGN_OR_RETURN(hdf5::FileWriter writer, hdf5::FileWriter::create(path));
  for (;;) {
    TROCAR_ASSIGN_OR_RETURN(const std::optional<TreeNode> node, receive_node(kSocket));
    if (!node) return fail(ErrorCode::kIo, "the program broke off");
    if (node->kind == TreeNode::Kind::kFailure) return writer.close();
    TROCAR_RETURN_IF_ERROR(writer.add(*node));
  }
}

Status run(std::string_view mode, const std::string& path) {
  hdf5::be_quiet();
  if (mode == "write") return write(path);
  return hdf5::read_file(path, [](const TreeNode& node) { return send_node(kSocket, node); });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  ::close_range(STDERR_FILENO + 1, ~0U, 0);
  ::setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
  set_limits();
  TreeNode last;
  last.kind = TreeNode::Kind::kFailure;
  try {
    const Status done = run(argv[1], argv[2]);
    if (!done) {
      last.why = done.error().text();
      last.attributes["code"] = static_cast<std::int64_t>(done.error().code());
    }
  } catch (const std::exception&) {  // only memory can be missing
    last.why = "the HDF5 file needs more memory than there is";
    last.attributes["code"] = static_cast<std::int64_t>(ErrorCode::kUnsupported);
  }
  // An empty sentence: all went well.
  return send_node(kSocket, last) ? 0 : 3;
}
