/// Small pictures of a demonstration along time, drawn behind the window and kept.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/core/image.h"
#include "engine/demonstration/demonstration.h"
#include "engine/workbench/command.h"
#include "engine/workbench/latest_worker.h"

namespace trocar::workbench {

/// Pictures as `ShowFilmstrip` asked for them, as far as they are drawn.
struct Filmstrip {
  std::shared_ptr<const demonstration::Demonstration> of;
  double first_s = 0.0;
  double step_s = 1.0;
  std::vector<std::shared_ptr<const Image>>
      pictures;              ///< Null where it is not drawn yet, and where there is no sample.
  std::uint64_t number = 0;  ///< Changes with each picture that comes.
};

/// Draws the missing pictures one after the other, from left to right. A picture is known by samples and instant, so
/// that one which an edit did not touch, or which another zoom shows too, is not drawn again. Its thread begins with
/// the first picture. Threads: the main thread.
class FilmstripMaker {
 public:
  static constexpr std::size_t kKept = 256;  ///< Pictures; 5 MB at 96 by 54.

  void ask(const ShowFilmstrip& wanted);
  /// Takes in what is ready and asks for what is missing. `shown` null: nothing is to be shown. True if `strip`
  /// changed.
  bool poll(const std::shared_ptr<const demonstration::Demonstration>& shown, bool light,
            std::shared_ptr<const Filmstrip>& strip);
  /// While pictures are still to come.
  bool busy() const { return changed_ || !missing_.empty() || pending(); }

 private:
  /// Hash of the sample and what else there is in a picture.
  using Key = std::tuple<std::uint64_t, int, bool>;
  struct Frame {
    Key key;
    demonstration::Sample sample;
    int block = 0;
    int height_px = 54;
    bool light = false;
  };
  struct Drawn {
    Key key;
    std::shared_ptr<const Image> image;
  };
  struct Kept {
    std::shared_ptr<const Image> image;
    std::uint64_t used = 0;
  };
  using Worker = LatestWorker<Frame, Drawn>;

  bool pending() const { return worker_ && worker_->pending(); }
  bool take_answer();
  /// What is to be drawn of what is wanted, and the strip as it is.
  std::shared_ptr<const Filmstrip> assemble(bool light);
  void forget_old();

  ShowFilmstrip wanted_;
  std::shared_ptr<const demonstration::Demonstration> shown_;
  bool light_ = false;
  bool changed_ = false;
  std::map<Key, Kept> kept_;
  std::vector<Frame> missing_;  ///< By falling time.
  std::uint64_t turn_ = 0;
  std::unique_ptr<Worker> worker_;
};

}  // namespace trocar::workbench
