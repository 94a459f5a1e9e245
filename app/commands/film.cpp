#include "app/commands/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/frame_folder.h"
#include "app/number_option.h"
#include "app/output_file.h"
#include "core/base/error.h"
#include "ui/film/film_frames.h"
#include "ui/film/ogg_film.h"
#include "ui/paper/picture_file.h"
#include "ui/scene/picture.h"

namespace feedscope {
namespace {

bool ends_in(const std::string& name, const std::string& ending) {
  return name.size() > ending.size() &&
         std::equal(ending.rbegin(), ending.rend(), name.rbegin(), [](char wanted, char found) {
           return wanted == std::tolower(static_cast<unsigned char>(found));
         });
}

void check_even(const ui::PictureRequest& picture) {
  const QSize pixels = (picture.size * picture.pixel_ratio).toSize();
  if (pixels.width() % 2 != 0 || pixels.height() % 2 != 0) {
    throw InputError(
        fmt::format("--size {}x{}: a film in .ogv needs an even width and height; use --size {}x{}",
                    pixels.width(), pixels.height(), pixels.width() / 2 * 2, pixels.height() / 2 * 2));
  }
}

ui::FilmTimes times_of(const FilmOptions& options, double duration) {
  ui::FilmTimes times;
  times.from = options.from.value_or(0);
  times.to = options.to.value_or(duration);
  times.speed = options.speed.value_or(ui::usual_film_speed(times.to - times.from));
  times.fps = options.fps.value_or(times.fps);
  check_film_times(times, duration);
  times.to = std::min(times.to, duration);
  return times;
}

}  // namespace

/// Destination of the frames.
class Film::Output {
 public:
  virtual ~Output() = default;
  virtual void add(const QImage& frame) = 0;
  virtual void commit() = 0;
};

class Film::OggOutput : public Film::Output {
 public:
  OggOutput(const std::string& name, int fps) : file_(name), film_(file_.written_to().string(), fps, name) {}
  void add(const QImage& frame) override { film_.add(frame); }
  void commit() override {
    film_.finish();
    file_.commit();
  }

 private:
  OutputFile file_;
  ui::OggFilm film_;
};

class Film::FrameOutput : public Film::Output {
 public:
  explicit FrameOutput(const std::string& pattern) : frames_(pattern) {}
  void add(const QImage& frame) override { frames_.add(ui::to_png(ui::picture_of(frame))); }
  void commit() override {
    frames_.commit();
    if (const std::string next = frames_.left_over(); !next.empty()) {
      fmt::print(stderr, "feedscope: note: '{}' is of an older film; remove it and those after it\n", next);
    }
  }

 private:
  FrameFolder frames_;
};

Film::Film(const FilmOptions& options, const ui::PictureRequest& picture)
    : options_(options), picture_(picture) {
  const bool ogg = ends_in(options.out, ".ogv");
  if (!ogg && !ends_in(options.out, ".png")) {
    throw InputError(
        fmt::format("--film '{}': end the name in .ogv, or give a series of pictures a name such as "
                    "frames/%05d.png",
                    options.out));
  }
  if (ogg && !ui::OggFilm::is_available()) {
    throw InputError(
        fmt::format("--film '{}': this build of Feedscope writes no .ogv, because its VTK has no "
                    "IOOggTheora; write a series of pictures instead: --film frames/%05d.png",
                    options.out));
  }
  if (options.from && options.to && *options.from >= *options.to) {
    throw InputError(
        fmt::format("--from {} is not before --to {}; give a time before it", *options.from, *options.to));
  }
  if (ogg) {
    check_even(picture);
    output_ = std::make_unique<OggOutput>(options.out, options.fps.value_or(ui::FilmTimes().fps));
  } else {
    output_ = std::make_unique<FrameOutput>(options.out);
  }
}

Film::~Film() = default;

void Film::write(const ui::ReportInput& input, Progress& progress) {
  const ui::FilmTimes times = times_of(options_, input.run().shown->run.trajectory->duration());
  ui::FilmFrames frames(input, times, {picture_, options_.trail, options_.charts});
  const std::size_t count = times.frames();
  for (std::size_t k = 0; k < count; ++k) {
    progress.report(static_cast<double>(k) / static_cast<double>(count));
    output_->add(frames.frame(k));
  }
  progress.report(1);
  output_->commit();
}

void add_film_options(CLI::App& command, FilmOptions& options) {
  command
      .add_option("--film", options.out,
                  "Write a film of the 3D view instead of a picture, with the moving tool: FILE.ogv, or a "
                  "series of pictures with their number in the name, such as frames/%05d.png. At most 36000 "
                  "frames")
      ->type_name("FILE.ogv|FILE%05d.png");
  const auto seconds = [&](const char* name, std::optional<double>& value, const std::string& text) {
    constexpr double longest = 1e9;
    add_number_option(
        command, name, numbers(0, longest), [&value](double typed) { value = typed; }, text)
        ->type_name("S");
  };
  seconds("--from", options.from, "Where the film begins, in seconds of the run [its start]");
  seconds("--to", options.to, "Where the film ends, in seconds of the run [its end]");
  constexpr double slowest = 1e-6;
  constexpr double fastest = 1e6;
  add_number_option(
      command, "--speed", numbers(slowest, fastest), [&options](double typed) { options.speed = typed; },
      "Seconds of the run in a second of the film [1 where the film lasts 5 to 30 s so, otherwise slower or "
      "faster, so that it does]")
      ->type_name("X");
  add_number_option(
      command, "--fps", whole_numbers(1, ui::most_frames_a_second),
      [&options](double typed) { options.fps = static_cast<int>(typed); }, "Frames of the film a second [25]")
      ->type_name("N");
  seconds("--trail", options.trail,
          "Length of the trail behind the tool, in seconds of the run; 0 for none [2 s of the film]");
  command.add_flag("--charts", options.charts,
                   "Charts of feed, acceleration and jerk below the view of the film, with a moving cursor");
}

}  // namespace feedscope
