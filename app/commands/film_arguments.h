/// How the command line says what a film is: options over a preset, or a job in a file.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/film/composition.h"

namespace trocar::app {

struct FilmArguments {
  std::vector<std::string> sources;   ///< Demonstrations and trials, or the one job.
  std::vector<std::string> rollouts;  ///< "MODEL" or "MODEL@I,J,K".
  std::optional<std::string> preset;
  std::optional<double> fps;
  std::optional<double> speed;
  std::optional<std::string> size;
  std::optional<std::string> layout;
  std::optional<std::string> sync;
  std::optional<std::string> camera;
  std::optional<std::string> codec;
  std::optional<int> crf;
  std::optional<std::string> quality;
  std::optional<std::string> overlays;
  bool no_captions = false;
};

void bind_film(CLI::App& verb, FilmArguments& arguments);

/// Whether the film is told by a file.
bool is_film_job(const FilmArguments& arguments);
/// Errors: kInvalidArgument; kIo, kCorrupt of a job; those of `film::check`.
Result<film::Composition> film_from(const FilmArguments& arguments);

}  // namespace trocar::app
