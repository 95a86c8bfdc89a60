/// Demonstrations in robomimic's HDF5 layout: group `data` with `total` and `env_args`, a group `data/demo_N` for each
/// with `num_samples`, `actions`, `states`, `rewards`, `dones` and `obs/…`, and filter keys `mask/…`.
///
/// robot0 is our left arm, robot1 our right one; positions p_WT in metres, quaternions x, y, z, w, jaws in radians.
/// `actions` are steps of the setpoints, see `actions.h`. `states` holds the columns of `columns()`, named by its
/// attribute `columns`; with `data/demo_N/trocar` beside it, everything but the edits is there to be read back. Joints
/// and blocks that were never recorded are in neither `obs` nor `states`. A reward is given for an outcome that is
/// known.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/exchange/imported.h"
#include "engine/exchange/tree_node.h"

namespace trocar::exchange {

/// Filter keys: each names places in the list of what is exported. Notes tagged "mask" and how a recording was made and
/// ended give further ones.
using Masks = std::map<std::string, std::vector<std::size_t>>;
using Documents = std::vector<std::shared_ptr<const demonstration::Demonstration>>;

/// A new file at `path`. Precondition: there is at least one. Errors: kIo, kUnsupported; kInvalidArgument for a
/// filter key that is no name.
Status write_robomimic(const Documents& documents, const Masks& masks, const std::filesystem::path& path);

/// The file has one rate for all, that of its first demonstration.
struct RobomimicRate {
  double rate_hz = 0.0;
  std::string lost;  ///< What that says of them is not true; empty: it is.
};
RobomimicRate rate_of(const Documents& documents);

/// What of `document` comes back from such a file, and what does not.
std::vector<std::string> kept_by_robomimic(const demonstration::Demonstration& document);
std::vector<std::string> lost_by_robomimic(const demonstration::Demonstration& document);

struct RobomimicOptions {
  std::vector<std::string> only;  ///< Names of demonstrations ("demo_3") or filter keys; empty: all.
  double rate_hz = 0.0;           ///< Of a file of another program; 0: what the file says, else 20.
};

/// Gathers the nodes of a file, and makes recordings of them.
class RobomimicReader {
 public:
  explicit RobomimicReader(RobomimicOptions options) : options_(std::move(options)) {}

  /// Keeps what is of use.
  Status take(TreeNode&& node);
  /// In the order of their numbers. Errors: kCorrupt naming the demonstration at fault; kNotFound for what `only` names
  /// and the file has not; kInvalidArgument for a rate that is not from 0.1 to 1000 Hz.
  Result<std::vector<Imported>> finish();

 private:
  Result<std::vector<std::string>> chosen() const;
  Result<Imported> demonstration(const std::string& name) const;
  std::vector<std::string> masks_of(const std::string& name) const;
  /// One sentence for each demonstration that a filter key names and the file lacks.
  std::vector<std::string> masks_beyond() const;

  RobomimicOptions options_;
  std::map<std::string, TreeNode> nodes_;
};

/// Errors: those of `read_hdf5` and of `RobomimicReader`.
Result<std::vector<Imported>> read_robomimic(const std::filesystem::path& path, const RobomimicOptions& options);

}  // namespace trocar::exchange
