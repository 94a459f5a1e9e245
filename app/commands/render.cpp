#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/command.h"
#include "app/commands/film.h"
#include "app/commands/language_option.h"
#include "app/display_units.h"
#include "app/number_option.h"
#include "app/option_text.h"
#include "app/output_file.h"
#include "app/output_format.h"
#include "app/picture_size.h"
#include "app/session_runs.h"
#include "app/trace_files.h"
#include "core/analysis/contour/lens.h"
#include "core/base/error.h"
#include "core/base/typed_number.h"
#include "ui/decide/decide_view.h"
#include "ui/report/pictures.h"
#include "ui/scene/colourings.h"
#include "ui/theme/offscreen_application.h"
#include "ui/window/main_window.h"
#include "ui/window/panels/pictures_of_panels.h"

namespace feedscope {
namespace {

enum class View { scene, charts, window, sheet };

struct RenderOptions {
  SeveralRunsOptions runs;
  TraceFiles traces;
  std::string view = "3d";
  std::string lens;          ///< a line, or a time such as 1.25s, as typed
  std::optional<int> place;  ///< number of a card of the report, from 1
  std::string size;          ///< as typed
  std::optional<double> dpi;
  double scale = 1;
  std::string camera;            ///< "": iso, or the session's
  std::string colour;            ///< key of a colouring; "": feed, or the session's
  std::optional<int> reference;  ///< number of a run, from 1
  std::string rapids;            ///< "": auto, or the session's
  std::string theme;             ///< "": light, or the session's
  std::string format;
  bool transparent = false;
  std::string language;
  std::string title;
  std::string out;
  FilmOptions film;
  bool progress = false;
};

const std::map<std::string, View> views{
    {"3d", View::scene}, {"charts", View::charts}, {"window", View::window}, {"sheet", View::sheet}};
const std::map<std::string, ui::ThemeKind> themes{{"light", ui::ThemeKind::light},
                                                  {"dark", ui::ThemeKind::dark}};
const std::map<std::string, ui::PictureFormat> picture_formats{
    {"png", ui::PictureFormat::png}, {"svg", ui::PictureFormat::svg}, {"pdf", ui::PictureFormat::pdf}};

constexpr double default_dpi = 300;
constexpr double units_per_inch = 96;

std::vector<std::string> colouring_keys() {
  std::vector<std::string> keys;
  std::ranges::transform(ui::all_colourings(), std::back_inserter(keys), ui::colouring_key);
  return keys;
}

ui::PictureFormat format_of(const RenderOptions& options) {
  if (options.format.empty() && asks_for_pages(options.out)) {
    return ui::PictureFormat::pages;
  }
  return picture_formats.at(output_format(options.out, options.format, {"png", "svg", "pdf"}));
}

ui::ThemeKind theme_of(const RenderOptions& options, const std::optional<ui::Session>& session) {
  if (!options.theme.empty()) {
    return themes.at(options.theme);
  }
  return session ? session->theme.value_or(ui::ThemeKind::light) : ui::ThemeKind::light;
}

ui::StandardView camera_of(const RenderOptions& options) {
  return camera_views.at(options.camera.empty() ? "iso" : options.camera);
}

/// Throws InputError for options that conflict with a film, or need one.
void check_film_use(const RenderOptions& options) {
  const FilmOptions& film = options.film;
  if (!film.asked() && options.out.empty()) {
    throw InputError("give --out FILE for a picture, or --film FILE for a film");
  }
  const std::vector<GivenOption> of_pictures{
      {"--out", !options.out.empty()},       {"--view", views.at(options.view) != View::scene},
      {"--format", !options.format.empty()}, {"--dpi", options.dpi.has_value()},
      {"--title", !options.title.empty()},   {"--transparent", options.transparent}};
  const std::vector<GivenOption> of_films{
      {"--from", film.from.has_value()},   {"--to", film.to.has_value()},
      {"--speed", film.speed.has_value()}, {"--fps", film.fps.has_value()},
      {"--trail", film.trail.has_value()}, {"--charts", film.charts}};
  for (const auto& [name, given] : film.asked() ? of_pictures : of_films) {
    if (given) {
      throw InputError(film.asked() ? fmt::format("{} has no effect on a film; omit it or --film", name)
                                    : fmt::format("{} has no effect without --film", name));
    }
  }
}

ui::PictureRequest request_of(const RenderOptions& options) {
  const ui::PictureFormat format = options.film.asked() ? ui::PictureFormat::png : format_of(options);
  const bool sheet = views.at(options.view) == View::sheet;
  const std::string size = !options.size.empty()   ? options.size
                           : sheet                 ? "A4"
                           : options.film.asked()  ? "1280x720"
                           : !options.lens.empty() ? "640x640"
                           : options.place         ? "832x580"
                                                   : "1280x960";
  const double dpi = options.dpi.value_or(default_dpi);
  const PageSize page = parse_page_size(size, dpi);
  if (page.paper && options.film.asked()) {
    throw InputError(
        fmt::format("--size {}: a film has pixels; give its width and height, such as 1280x720", size));
  }
  const bool by_dots = page.paper.has_value() || format != ui::PictureFormat::png;
  if (options.dpi && !by_dots) {
    throw InputError(
        fmt::format("--dpi has no effect with {} pixels; give --size as a sheet (A4, A3-portrait, "
                    "Letter) or write .svg or .pdf",
                    size));
  }
  ui::PictureRequest request;
  request.format = format;
  request.paper = page.paper;
  request.transparent = options.transparent;
  const double pixels_a_unit = page.paper ? options.scale * dpi / units_per_inch : options.scale;
  request.size = QSizeF(page.pixels.width, page.pixels.height) / pixels_a_unit;
  request.pixel_ratio =
      page.paper || format == ui::PictureFormat::png ? pixels_a_unit : options.scale * dpi / units_per_inch;
  return request;
}

void check_view(const RenderOptions& options) {
  if (views.at(options.view) == View::window && !options.traces.files.empty()) {
    throw InputError("--trace has no effect with --view window; use --view 3d, charts or sheet");
  }
  const bool coloured = views.at(options.view) == View::scene || views.at(options.view) == View::sheet;
  if (!options.colour.empty() && !coloured) {
    throw InputError(
        fmt::format("--colour has no effect with --view {}; use --view 3d or sheet", options.view));
  }
  if (!options.rapids.empty() && !coloured) {
    throw InputError(
        fmt::format("--rapids has no effect with --view {}; use --view 3d or sheet", options.view));
  }
  if (views.at(options.view) == View::window && options.transparent) {
    throw InputError(
        "--transparent: the window has no transparent background; use --view 3d, charts or sheet");
  }
}

void check_close_up_use(const RenderOptions& options) {
  if (options.lens.empty() && !options.place) {
    return;
  }
  const char* const asked = options.place ? "--place" : "--lens";
  const std::vector<GivenOption> others{{"--lens", options.place && !options.lens.empty()},
                                        {"--view", views.at(options.view) != View::scene},
                                        {"--camera", !options.camera.empty()},
                                        {"--colour", !options.colour.empty()},
                                        {"--rapids", !options.rapids.empty()},
                                        {"--reference", options.reference.has_value()},
                                        {"--trace", !options.traces.files.empty()},
                                        {"--film", options.film.asked()}};
  for (const auto& [name, given] : others) {
    if (given) {
      throw InputError(fmt::format("{} has no effect with {}; omit one of them", name, asked));
    }
  }
}

/// The time in a run that --lens names [s]. Throws InputError for one outside the run.
double lens_instant(const std::string& asked, const Run& run) {
  const double duration = run.trajectory->duration();
  if (asked.ends_with('s')) {
    const std::optional<double> time = typed_number(asked.substr(0, asked.size() - 1)).value;
    if (!time || !(*time >= 0) || *time > duration) {
      throw InputError(fmt::format(
          "--lens {}: a time is a number of seconds from 0 to the cycle time, {:.3f}s", asked, duration));
    }
    return *time;
  }
  std::uint32_t line = 0;
  const auto [end, error] = std::from_chars(asked.data(), asked.data() + asked.size(), line);
  if (error != std::errc() || end != asked.data() + asked.size()) {
    throw InputError(
        fmt::format("--lens {}: give the number of a line, such as 20, or a time, such as 1.25s", asked));
  }
  const std::optional<double> time = lens_time(run, line);
  if (!time) {
    throw InputError(fmt::format("--lens {}: line {} moves nothing; give a line with a motion", asked, line));
  }
  return *time;
}

/// Pixels to a unit of a screen with so many pixels: on one of 3840x2160 a window has the type and the
/// composition of 1920x1080.
double screen_ratio(const QSizeF& pixels) {
  constexpr QSizeF usual(1920, 1080);
  return std::max(1.0,
                  std::floor(std::min(pixels.width() / usual.width(), pixels.height() / usual.height())));
}

std::string window_file(const ui::ReportInput& input, const RenderOptions& options,
                        const std::optional<ui::Session>& session, const ui::PictureRequest& request) {
  ui::WindowLook look{camera_of(options), request.theme};
  look.language = QString::fromStdString(options.language);
  look.prepare = [&](ui::MainWindow& window, ui::Workbench&) {
    if (session) {
      window.session().show(*session);
      return;
    }
    std::vector<ui::SetupState> others;
    for (std::size_t i = 1; i < input.runs.size(); ++i) {
      others.emplace_back(input.runs[i].shown->run.setup);
    }
    if (!others.empty()) {
      window.part<ui::DecideView>().compare_with(others);
    }
  };
  const double ratio = request.paper ? 1 : screen_ratio(request.size);
  look.pixel_ratio = ratio * request.pixel_ratio;
  const QSize size = (request.size / ratio).toSize();
  const ui::Picture picture = ui::draw_window(input.run().shown->run, {size.width(), size.height()}, look);
  if (request.format == ui::PictureFormat::png && !request.paper) {
    return ui::to_png(picture);
  }
  const ui::OffscreenApplication application(request.theme);
  const QImage image(picture.rgb.data(), picture.size.width, picture.size.height, 3 * picture.size.width,
                     QImage::Format_RGB888);
  return ui::image_file(image, request, input.heading());
}

std::string picture_file(ui::ReportInput& input, const RenderOptions& options,
                         const std::optional<ui::Session>& session, const ui::PictureRequest& request) {
  const View view = views.at(options.view);
  if (view == View::window) {
    return window_file(input, options, session, request);
  }
  const ui::OffscreenApplication application(request.theme);
  speak_in(options.language, input, session);
  if (options.place) {
    return ui::place_file(input, static_cast<std::size_t>(*options.place), request);
  }
  if (!options.lens.empty()) {
    return ui::lens_file(input, lens_instant(options.lens, input.run().shown->run), request);
  }
  return view == View::scene    ? ui::scene_file(input, request)
         : view == View::charts ? ui::charts_file(input, request)
                                : ui::sheet_file(input, request);
}

/// The parts of a run that the picture or the film needs.
ui::ShownParts parts_of(const RenderOptions& options) {
  if (options.place) {
    return {};  // which run is recommended depends on its summary
  }
  const View view = views.at(options.view);
  const bool sheet = view == View::sheet || options.film.asked();
  const bool lens = !options.lens.empty();
  const bool scene = view == View::scene && !lens;
  const bool charts = view == View::charts && !lens;
  return {sheet || scene, sheet || charts, sheet, sheet || !(scene || charts)};
}

void set_colours(const RenderOptions& options, ui::ReportInput& input) {
  if (!options.colour.empty()) {
    input.scene.colouring = *std::ranges::find(ui::all_colourings(), options.colour, ui::colouring_key);
  }
  const auto count = static_cast<int>(input.runs.size());
  if (ui::needs_reference(input.scene.colouring) && count < 2) {
    throw InputError(
        fmt::format("--colour {} compares two runs, but there is only one; give another --tolerance, --model "
                    "or --machine",
                    ui::colouring_key(input.scene.colouring)));
  }
  const QuantitySource source = ui::source_of(input.scene.colouring);
  const bool available = std::ranges::any_of(
      input.runs, [source](const ui::ReportRun& run) { return run.shown->run.sources.has(source); });
  if (!available && options.colour.empty()) {
    input.scene.colouring = ui::Colouring::feed;  // as in the window for such a session
  } else if (!available && source == QuantitySource::drives) {
    throw InputError(fmt::format(
        "--colour {} shows what the drives do, but no axis of machine {} has one; give --set "
        "X.kv=60 and the like, or a machine with kv_1_s",
        ui::colouring_key(input.scene.colouring), input.runs.front().shown->run.setup.machine.id));
  } else if (!available) {
    throw InputError(
        fmt::format("--colour {} shows the cutting load, which needs to know how the tools are engaged; give "
                    "--load FILE",
                    ui::colouring_key(input.scene.colouring)));
  }
  if (!options.reference) {
    return;
  }
  if (*options.reference < 1 || *options.reference > count) {
    throw InputError(
        fmt::format("--reference {} is not a run; there are {}, counted from 1 in the order of the "
                    "options",
                    *options.reference, count));
  }
  input.reference = static_cast<std::size_t>(*options.reference - 1);
}

/// The command in the foot of a sheet, which produces the same bytes again.
QString command_of(const RenderOptions& options) {
  std::string text = fmt::format("feedscope render {} --view {}", options_text(options.runs), options.view);
  const auto add = [&](const char* name, const std::string& value) {
    text += value.empty() ? "" : fmt::format(" {} {}", name, in_quotes(value));
  };
  text += command_text(options.traces);
  add("--lens", options.lens);
  add("--place", options.place ? std::to_string(*options.place) : "");
  add("--size", options.size);
  add("--title", options.title);
  add("--camera", options.camera == "iso" ? "" : options.camera);
  add("--colour", options.colour);
  add("--reference", options.reference ? std::to_string(*options.reference) : "");
  add("--rapids", options.rapids);
  add("--dpi", options.dpi ? fmt::format("{}", *options.dpi) : "");
  add("--scale", options.scale != 1 ? fmt::format("{}", options.scale) : "");
  add("--theme", options.theme);
  add("--display-units", asked_display_units());
  add("--language", options.language == usual_language() ? "" : options.language);
  add("--format", options.format);
  text += options.transparent ? " --transparent" : "";
  add("--out", options.out);
  return QString::fromStdString(text);
}

int render(const RenderOptions& options) {
  check_film_use(options);
  check_close_up_use(options);
  std::optional<ui::Session> session = asked_session(options.runs);
  if (session) {
    session->load = asked_load(options.runs.load, std::move(session->load));
  }
  ui::PictureRequest request = request_of(options);
  request.theme = theme_of(options, session);
  const auto source =
      session ? nullptr : std::make_shared<const SourceText>(SourceText::from_file(options.runs.file));
  const std::vector<AskedRun> runs =
      session ? std::vector<AskedRun>() : asked_runs(options.runs, dialect_of(options.runs, *source));
  check_view(options);
  check_outputs(options.runs.file, {options.out, options.film.out});
  check_outputs(options.runs.load, {options.out, options.film.out}, "the load file");
  for (const std::string& trace : options.traces.files) {
    check_outputs(trace, {options.out, options.film.out}, "a trace");
  }
  if (session) {
    check_outputs(session->program.string(), {options.out, options.film.out});
  }
  std::optional<OutputFile> out;
  std::optional<Film> film;
  if (options.film.asked()) {
    film.emplace(options.film, request);
  } else {
    out.emplace(options.out);
  }
  if (options.progress) {
    Watch::tell_in_lines();
  }
  std::optional<Watch> watch(std::in_place);
  ui::ReportInput input =
      session ? simulate_session(*session, *watch)
              : simulate_runs(options.runs.reading(), runs, source, *watch, parts_of(options));
  add_traces(input, options.traces, *watch);
  if (!session || !options.camera.empty()) {
    input.view = camera_of(options);
  }
  set_colours(options, input);
  if (!options.rapids.empty()) {
    input.scene.rapids = options.rapids != "hide";
    input.scene.all_rapids = options.rapids == "show";
  }
  input.title = QString::fromStdString(options.title);
  input.commands = {command_of(options)};
  if (film) {
    const ui::OffscreenApplication application(request.theme);
    speak_in(options.language, input, session);
    film->write(input, *watch->stage("drawing"));
  }
  watch.reset();
  if (out) {
    out->stream() << picture_file(input, options, session, request);
    out->commit();
  }
  return tell_of_shown_runs(input, options.runs.tolerances);
}

void add_size_options(CLI::App& command, RenderOptions& options) {
  command
      .add_option(
          "--size", options.size,
          "Width and height in pixels, or a sheet of paper: A4 (landscape), A4-portrait, A2 to A6, Letter; a "
          "--view sheet smaller than A4 needs a --scale below 1 [1280x960; 1280x720 for a film; 640x640 for "
          "--lens; 832x580 for --place; A4 for a sheet]")
      ->type_name("WxH|PAPER");
  add_number_option(
      command, "--dpi", numbers(36, 1200), [&options](double dpi) { options.dpi = dpi; },
      "Pixels per inch of paper. SVG and PDF hold vectors, thinned to this; a 3D view of more than 250 000 "
      "pieces of line, and --view window, are bitmaps of it [300]")
      ->type_name("N");
  add_number_option(
      command, "--scale", numbers(0.25, 8), [&options](double scale) { options.scale = scale; },
      "Scale of text and lines [1]")
      ->type_name("S");
}

}  // namespace

Command add_render_command(CLI::App& app) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand(
      "render",
      "Draw an NC program and its motion as a PNG, SVG or PDF picture, or as a film; needs no display");
  add_several_runs_options(*command, options->runs);
  add_trace_files(*command, options->traces);
  command->add_option("--view", options->view, "View to draw: 3d, charts, window, sheet")
      ->check(CLI::IsMember(views))
      ->type_name("VIEW")
      ->capture_default_str();
  command
      ->add_option(
          "--lens", options->lens,
          "Draw all runs over each other at a corner, stretched across the path: at the sharpest corner of a "
          "line, or where the first run is at a time, such as 1.25s")
      ->type_name("LINE|TIME");
  add_number_option(
      *command, "--place", whole_numbers(1, 1'000'000),
      [options](double number) { options->place = static_cast<int>(number); },
      "Draw the report's picture of the place with this number among those that lose most")
      ->type_name("N");
  add_size_options(*command, *options);
  command
      ->add_option("--camera", options->camera,
                   "View direction: iso, top, front, right [iso, or the session's]")
      ->check(CLI::IsMember(camera_views))
      ->type_name("CAMERA");
  command
      ->add_option("--colour", options->colour,
                   "Quantity shown by the colour of the path: " +
                       fmt::format("{}", fmt::join(colouring_keys(), ", ")) +
                       "; time_lost and path_distance compare the first run with another one [feed, or the "
                       "session's]")
      ->check(CLI::IsMember(colouring_keys()))
      ->type_name("COLOUR");
  add_number_option(
      *command, "--reference", whole_numbers(1, 1'000'000),
      [options](double number) { options->reference = static_cast<int>(number); },
      "The run that --colour time_lost and path_distance compare with [the first other one]")
      ->type_name("N");
  command
      ->add_option("--rapids", options->rapids,
                   "Rapids: show, hide, or auto, which hides them where they cover more than 5 % of the "
                   "picture [auto, or the session's]")
      ->check(CLI::IsMember({"show", "hide", "auto"}));
  command->add_option("--theme", options->theme, "Colours: light, dark [light, or the session's]")
      ->check(CLI::IsMember(themes))
      ->type_name("THEME");
  add_display_units_option(*command);
  command->add_option("--format", options->format, "png, svg or pdf [the ending of --out]")
      ->check(CLI::IsMember(picture_formats))
      ->type_name("FORMAT");
  add_language_option(*command, options->language);
  command->add_flag("--transparent", options->transparent, "Transparent background");
  command->add_option("--title", options->title, "Title of a sheet [the program's name]")->type_name("TEXT");
  command->add_option("--out", options->out, "The picture to write; - for standard output")
      ->type_name("FILE.png|svg|pdf");
  add_film_options(*command, options->film);
  command->add_flag("--progress", options->progress,
                    "Tell the progress on standard error in lines, for programs that run this one");
  return {command, [options] {
            move_tolerance(options->runs.set, options->runs.tolerances);
            return render(*options);
          }};
}

}  // namespace feedscope
