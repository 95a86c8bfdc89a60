#include "ui/panels/export_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "engine/media/video_writer.h"
#include "ui/film_text.h"
#include "ui/format.h"
#include "ui/forms/export_parts.h"
#include "ui/icons.h"
#include "ui/panels/common.h"
#include "ui/panels/export_look.h"
#include "ui/panels/export_queue.h"
#include "ui/panels/export_tracks.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::FilmDraft;
using workbench::FilmPreview;

constexpr int kQueuePage = 4;

/// The picture in the largest rectangle of its shape that has room in `room`.
Rect fitting(const Rect& room, const Image& picture) {
  const float factor =
      std::min(room.width() / static_cast<float>(picture.width), room.height() / static_cast<float>(picture.height));
  const float wide = factor * static_cast<float>(picture.width);
  const float tall = factor * static_cast<float>(picture.height);
  const float x = room.x0 + 0.5F * (room.width() - wide);
  const float y = room.y0 + 0.5F * (room.height() - tall);
  return {x, y, x + wide, y + tall};
}

/// How much the file may lose of the picture: what is usual, or a number.
void draw_loss(Ui& ui, film::Composition& film, media::Codec said) {
  const auto codec = media::codec_for(film.path, said);
  const media::Crf crf = codec ? media::crf_of(*codec) : media::Crf{};
  form_label(ui, "Loss");
  bool chosen = film.crf.has_value();
  if (checkbox(ui, "Choose the loss", chosen,
               {.help = "By the constant rate factor: less looks better and takes more room",
                .reason = crf.most > 0 || chosen ? "" : "Only H.264, VP9 and AV1 have a constant rate factor"})) {
    film.crf = chosen ? std::optional(crf.usual) : std::nullopt;
  }
  if (!film.crf || crf.most == 0) return;
  form_label(ui, "CRF");
  slider_int(ui, "CRF", *film.crf, media::Crf::kLeast, crf.most, "CRF %d");
}

void whole_number(Ui& ui, std::string_view shown, int& value, int low, int high, std::string_view help) {
  form_label(ui, shown);
  std::int64_t typed = value;
  number_field(ui, shown, typed, low, high, {.help = help});
  value = static_cast<int>(std::clamp<std::int64_t>(typed, 0, 100'000));
}

}  // namespace

void ExportPanel::ask_for_preview(const WorkbenchState& state, Requests& requests) {
  const FilmDraft& draft = state.film;
  if (draft.film.sources.empty() || !film::check(draft.film)) return;
  film::Composition look = workbench::look_of(draft.film);
  if (asked_in_ == state.project && asked_at_s_ == draft.at_s && asked_ == look) return;
  asked_in_ = state.project;
  asked_at_s_ = draft.at_s;
  asked_ = std::move(look);
  requests.emplace_back(Command{workbench::PreviewFilm{}});
}

void ExportPanel::draw_preview(Ui& ui, const WorkbenchState& state, FilmDraft& draft) {
  const FilmPreview* preview = state.film_preview.get();
  const bool shown = preview != nullptr && preview->picture && !draft.film.sources.empty();
  const float wide = ImGui::GetContentRegionAvail().x;
  const float tall = std::min({wide * 9.0F / 16.0F, ui.px(300), std::max(ui.px(110), 0.4F * ImGui::GetWindowHeight())});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect room{at.x, at.y, at.x + wide, at.y + tall};
  ImGui::Dummy({wide, tall});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({room.x0, room.y0}, {room.x1, room.y1}, to_u32(ui.theme().raised), ui.px(3));
  if (shown) {
    const Rect rect = fitting(room, *preview->picture);
    const ImTextureID texture =
        ui.textures().texture("film preview", *preview->picture, preview->number, Sampling::kLinear);
    list.AddImage(texture, {rect.x0, rect.y0}, {rect.x1, rect.y1});
  } else {
    const FontScope font(ui.fonts().small);
    const std::string words = fitted(state.film_preview_pending ? "Drawing…" : "What is filmed shows here", wide);
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    list.AddText({room.centre_x() - 0.5F * size.x, room.y0 + 0.5F * (tall - size.y)}, to_u32(ui.theme().text_dim),
                 words.c_str());
  }
  note_rect(ui, "picture", "Preview", shown ? fmt::format("frame {} of {}", preview->frame + 1, preview->frames) : "",
            room);
  // The film may have become shorter.
  const bool current = shown && !state.film_preview_pending && preview->of == workbench::look_of(draft.film);
  if (current) draft.at_s = std::min(draft.at_s, preview->length_s);
  auto instant = static_cast<float>(draft.at_s);
  const float length = shown ? static_cast<float>(preview->length_s) : 0.0F;
  form_label(ui, "Instant");
  if (slider_float(ui, "Instant", instant, 0.0F, std::max(length, 0.01F), "%.2f s",
                   {.help = "Of the film: what the picture shows, and where a key of a camera is added",
                    .reason = shown ? "" : "There is no picture yet"})) {
    draft.at_s = std::clamp(static_cast<double>(instant), 0.0, shown ? preview->length_s : 0.0);
  }
  small_text(ui,
             shown ? fmt::format("Frame {} of {}, {}", preview->frame + 1, count(preview->frames), seconds(length))
                   : "No frame yet",
             ui.theme().text_dim);
  // What comes and goes with the picture has its room always: nothing below moves from under the mouse.
  const float top = ImGui::GetCursorPosY();
  if (const std::string why = film_reason(state); !why.empty()) {
    wrapped_text(ui, why, draft.film.sources.empty() ? ui.theme().text_dim : ui.theme().warning);
  } else if (shown && !preview->warning.empty()) {
    wrapped_text(ui, preview->warning, ui.theme().text_dim);
  }
  const float room_left = ImGui::GetTextLineHeightWithSpacing() - (ImGui::GetCursorPosY() - top);
  if (room_left > 0.0F) ImGui::Dummy({0.0F, std::max(0.0F, room_left - ImGui::GetStyle().ItemSpacing.y)});
}

void ExportPanel::draw_job(Ui& ui, const WorkbenchState& state, FilmDraft& draft, Requests& requests) {
  heading(ui, "Job in a file");
  form_label(ui, "Job");
  text_field(ui, "Job", draft.job, "film.json", {.help = "All of the film as text, for trocar video render"});
  const std::string unnamed = draft.job.empty() ? "Type a file name" : "";
  const std::string unsaved = draft.job.empty() ? unnamed : reason_against_path(draft.job, state);
  if (button(ui, "Save job", {.icon = icon::kDownload, .help = "Write the film as a job", .reason = unsaved})) {
    requests.emplace_back(Command{workbench::SaveFilmJob{draft.job}});
  }
  flow(button_width(ui, "Open job", icon::kFolder), ui.px(6));
  if (button(ui, "Open job",
             {.icon = icon::kFolder, .help = "Make the film of a job; this one is left", .reason = unnamed})) {
    requests.emplace_back(Command{workbench::OpenFilmJob{draft.job}});
  }
  const std::string words = film_text(draft.film, state);
  flow(button_width(ui, "Copy as command", icon::kCopy), ui.px(6));
  if (button(ui, "Copy as command",
             {.icon = icon::kCopy,
              .help = words.empty() ? std::string_view("The film as the command line says it") : words,
              .reason = words.empty() ? "Save the job first: words alone cannot say all of this film" : ""})) {
    requests.emplace_back(CopyText{words});
  }
}

void ExportPanel::draw_file(Ui& ui, const WorkbenchState& state, FilmDraft& draft, Requests& requests) {
  static const std::vector<std::string> kCodecNames{"Auto", "H.264", "MPEG-4", "FFV1", "MJPEG", "VP9", "AV1", "GIF"};
  film::Composition& film = draft.film;
  const Scope scope(ui, "File");
  whole_number(ui, "Width", film.width, 16, 8192, "In pixels; made even");
  whole_number(ui, "Height", film.height, 16, 8192, "In pixels; made even");
  auto rate = static_cast<int>(film.fps);
  const int rate_before = rate;
  whole_number(ui, "Frames a second", rate, 1, 240, "Of the film, whatever the recording has");
  if (rate != rate_before) film.fps = rate;
  const auto known = media::codec_from(film.codec);
  int codec = known ? static_cast<int>(*known) : -1;
  form_label(ui, "Codec");
  if (segmented(ui, "Codec", codec, kCodecNames, {.help = "Sets the file's ending, too; FFV1 loses nothing"})) {
    const auto chosen = static_cast<media::Codec>(codec);
    film.codec = media::to_string(chosen);
    film.path = std::filesystem::path(film.path).replace_extension(media::usual_ending(chosen)).string();
    // One codec's number means little to another.
    const auto codec_of_file = media::codec_for(film.path, chosen);
    const media::Crf crf = codec_of_file ? media::crf_of(*codec_of_file) : media::Crf{};
    if (film.crf) film.crf = crf.most > 0 ? std::optional(crf.usual) : std::nullopt;
  }
  draw_loss(ui, film, known.value_or(media::Codec::kAuto));
  form_label(ui, "File");
  text_field(ui, "File", film.path, "film.mp4", {.help = "F_%05d.png writes a row of pictures"});
  std::error_code error;
  if (!film.path.empty() && std::filesystem::is_regular_file(film.path, error)) {
    wrapped_text(ui, "There is such a file already: it is replaced", ui.theme().warning);
  }
  ImGui::Dummy({0.0F, ui.px(4)});
  const std::string why = film_reason(state);
  if (button(ui, "Add to queue",
             {.icon = icon::kFilm,
              .help = "Render the film, behind what runs already",
              .reason = why,
              .width = -1.0F,
              .style = ButtonStyle::kPrimary})) {
    requests.emplace_back(Command{workbench::RenderFilm{film}});
    page_ = kQueuePage;
  }
  const auto films = workbench::films_of_session(*state.project, film);
  if (button(ui, "Add all of its session",
             {.icon = icon::kCopy,
              .help = "A film like this one of each trial of the session, in a file of its name",
              .reason = !why.empty() ? why
                        : films      ? ""
                                     : "Make it a film of one trial, and no row of pictures",
              .width = -1.0F})) {
    for (const film::Composition& one : *films) requests.emplace_back(Command{workbench::RenderFilm{one}});
    page_ = kQueuePage;
  }
  ImGui::Dummy({0.0F, ui.px(4)});
  draw_job(ui, state, draft, requests);
}

Requests ExportPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  static const std::vector<std::string> kPages{"Sources", "Keys", "Look", "File", "Queue"};
  segmented(ui, "Page", page_, kPages,
            {.help = "What is filmed, what of it changes, how it looks, into which file, and what is being rendered"});
  ImGui::Dummy({0.0F, ui.px(4)});
  if (page_ == kQueuePage) {
    draw_film_queue(ui, state, requests);
    return requests;
  }
  FilmDraft draft = state.film;
  draw_preview(ui, state, draft);
  ImGui::Dummy({0.0F, ui.px(4)});
  Requests asked;
  if (page_ == 0) draw_film_sources(ui, state, draft, added_, asked);
  if (page_ == 1) draw_film_tracks(ui, state, draft, keys_of_);
  if (page_ == 2) draw_film_look(ui, draft.film);
  if (page_ == 3) draw_file(ui, state, draft, asked);
  // What is asked for is asked of the film as it is now.
  if (draft != state.film) requests.emplace_back(Command{workbench::SetFilm{draft}});
  append(requests, std::move(asked));
  ask_for_preview(state, requests);
  return requests;
}

}  // namespace trocar::ui
