#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "ui/report/pictures.h"

namespace feedscope {

/// Options of `render` for a film.
struct FilmOptions {
  std::string out;             ///< "": no film
  std::optional<double> from;  ///< [s]
  std::optional<double> to;    ///< [s]
  std::optional<double> speed;
  std::optional<int> fps;
  std::optional<double> trail;  ///< [s]
  bool charts = false;

  bool asked() const { return !out.empty(); }
};

/// Adds --film and its options; `options` must live as long as the command.
void add_film_options(CLI::App& command, FilmOptions& options);

/// A film, written whole or not at all.
class Film {
 public:
  /// Throws InputError, before any work is done, for options that conflict and if the film cannot be written.
  /// `picture`: its size, pixel ratio and theme.
  Film(const FilmOptions& options, const ui::PictureRequest& picture);
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  /// Draws and writes the film. Throws InputError for times outside the run, too many frames, and if not
  /// everything could be written; Cancelled. Needs a QApplication with the theme.
  void write(const ui::ReportInput& input, Progress& progress);

 private:
  class Output;
  class OggOutput;
  class FrameOutput;

  FilmOptions options_;
  ui::PictureRequest picture_;
  std::unique_ptr<Output> output_;
};

}  // namespace feedscope
