/// How a function says that the world said no: `Result<T>` and `Status`, and the error inside them.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

namespace trocar {

/// What kind of thing went wrong; the command line maps it to an exit code.
enum class ErrorCode {
  kInvalidArgument,  ///< The caller's input makes no sense (exit 2).
  kNotFound,         ///< Nothing has that name or id (exit 2).
  kOutOfReach,       ///< A pose or state that the arm or the lattice cannot have.
  kCheckFailed,      ///< A check was run and did not hold (exit 1).
  kIo,               ///< File, device or codec (exit 3).
  kCorrupt,          ///< A file that is not what it claims to be (exit 3).
  kUnsupported,      ///< A newer schema, or a part this machine lacks (exit 3).
  kCancelled,        ///< The user asked to stop (exit 3).
};

/// One sentence for the user without a full stop, and what it is about. The path, if any, is printed last.
class [[nodiscard]] Error {
 public:
  Error(ErrorCode code, std::string message) : code_(code), message_(std::move(message)) {}

  /// Says what was being done: "could not <doing>: <message>". For rvalues, so that errors are passed on by move.
  Error in(std::string_view doing) &&;
  /// Names the file; the first one given stays.
  Error at(std::string path) &&;

  ErrorCode code() const { return code_; }
  /// The whole sentence, the path last.
  std::string text() const;

 private:
  ErrorCode code_;
  std::string message_;
  std::string path_;
};

template <typename T>
using Result = tl::expected<T, Error>;
using Status = tl::expected<void, Error>;

/// `return fail(ErrorCode::kNotFound, "no demonstration is named 7")`.
inline tl::unexpected<Error> fail(ErrorCode code, std::string message) {
  return tl::unexpected<Error>(Error(code, std::move(message)));
}

}  // namespace trocar

#define TROCAR_CONCAT_INNER(a, b) a##b
#define TROCAR_CONCAT(a, b) TROCAR_CONCAT_INNER(a, b)

/// Passes an error on: `TROCAR_RETURN_IF_ERROR(write(file))`.
#define TROCAR_RETURN_IF_ERROR(expression)                                      \
  do {                                                                          \
    if (auto trocar_status = (expression); !trocar_status) {                    \
      return tl::unexpected<::trocar::Error>(std::move(trocar_status).error()); \
    }                                                                           \
  } while (false)

/// Passes an error on or takes the value: `TROCAR_ASSIGN_OR_RETURN(const Grid grid, read_grid(path))`.
#define TROCAR_ASSIGN_OR_RETURN(declaration, expression) \
  TROCAR_ASSIGN_OR_RETURN_INNER(TROCAR_CONCAT(trocar_result_, __LINE__), declaration, expression)
#define TROCAR_ASSIGN_OR_RETURN_INNER(temporary, declaration, expression)                 \
  auto temporary = (expression);                                                          \
  if (!(temporary)) return tl::unexpected<::trocar::Error>(std::move(temporary).error()); \
  declaration = std::move(*(temporary))
