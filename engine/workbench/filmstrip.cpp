#include "engine/workbench/filmstrip.h"

#include <algorithm>
#include <utility>

#include "engine/scene/scene.h"
#include "engine/stage/stage.h"
#include "engine/workbench/studio.h"

namespace trocar::workbench {

void FilmstripMaker::ask(const ShowFilmstrip& wanted) {
  ShowFilmstrip cut = wanted;
  cut.count = std::clamp(wanted.count, 0, kFilmstripPictures);
  cut.height_px = std::clamp(wanted.height_px, 16, 256);
  if (cut == wanted_) return;
  wanted_ = cut;
  changed_ = true;
}

bool FilmstripMaker::take_answer() {
  if (!worker_ || !worker_->update()) return false;
  const Drawn& drawn = worker_->answer();
  kept_[drawn.key] = {drawn.image, turn_};
  std::erase_if(missing_, [&](const Frame& frame) { return frame.key == drawn.key; });
  return true;
}

void FilmstripMaker::forget_old() {
  while (kept_.size() > kKept) {
    const auto oldest = std::min_element(kept_.begin(), kept_.end(),
                                         [](const auto& a, const auto& b) { return a.second.used < b.second.used; });
    if (oldest->second.used == turn_) return;
    kept_.erase(oldest);
  }
}

std::shared_ptr<const Filmstrip> FilmstripMaker::assemble(bool light) {
  missing_.clear();
  if (!shown_ || wanted_.count == 0 || shown_->samples.empty()) return nullptr;
  ++turn_;
  auto strip = std::make_shared<Filmstrip>();
  strip->of = shown_;
  strip->first_s = wanted_.first_s;
  strip->step_s = wanted_.step_s;
  strip->number = turn_;
  for (int i = 0; i < wanted_.count; ++i) {
    auto& picture = strip->pictures.emplace_back();
    const double t_s = wanted_.first_s + i * wanted_.step_s;
    if (t_s < 0.0 || t_s > shown_->full_duration_s()) continue;
    // Outside of the gates, too: what was trimmed can be seen there.
    const std::size_t after = shown_->samples.lower_bound(shown_->tick_after(t_s));
    Frame frame;
    frame.sample = shown_->samples[after == 0 ? 0 : after - 1];
    frame.block = shown_->recording->provenance.block;
    frame.height_px = wanted_.height_px;
    frame.light = light;
    // The instant does not show in the picture: samples that only moved in time are the same.
    demonstration::Sample timeless = frame.sample;
    timeless.tick = 0;
    frame.key = {demonstration::hash_of({&timeless, 1}), wanted_.height_px, light};
    const auto found = kept_.find(frame.key);
    if (found == kept_.end()) {
      missing_.push_back(std::move(frame));
      continue;
    }
    found->second.used = turn_;
    picture = found->second.image;
  }
  std::reverse(missing_.begin(), missing_.end());
  forget_old();
  return strip;
}

bool FilmstripMaker::poll(const std::shared_ptr<const demonstration::Demonstration>& shown, bool light,
                          std::shared_ptr<const Filmstrip>& strip) {
  const bool another = shown != shown_ || light != light_;
  shown_ = shown;
  light_ = light;
  const bool asked = std::exchange(changed_, false);
  const bool anew = take_answer() || another || asked;
  if (anew) strip = assemble(light);
  if (missing_.empty() || pending()) return anew;
  if (!worker_) {
    worker_ = std::make_unique<Worker>([] {
      auto studio = std::make_shared<Result<Studio>>(Studio::create());
      return [studio](const Frame& frame) -> Drawn {
        if (!*studio) return {frame.key, nullptr};
        ViewRequest request;
        request.pose = stage::pose_of(frame.sample);
        request.options.highlighted_block = frame.block;
        request.options.labels = request.options.scale_bar = false;
        request.camera = scene::camera(scene::CameraPreset::kPaper);
        request.options.light_ground = frame.light;
        request.render.height = frame.height_px;
        request.render.width = frame.height_px * 16 / 9;
        request.render.samples = 4;
        Result<Image> image = (*studio)->picture(request);
        // Why there is none, the 3-D view says.
        return {frame.key, image ? std::make_shared<const Image>(std::move(*image)) : nullptr};
      };
    });
  }
  worker_->request(missing_.back());
  return anew;
}

}  // namespace trocar::workbench
