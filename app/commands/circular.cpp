#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "app/asked_program.h"
#include "app/circular_text.h"
#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/number_option.h"
#include "app/output_file.h"
#include "app/run_options.h"
#include "app/run_remarks.h"
#include "app/watch.h"
#include "core/analysis/circularity/program_circles.h"
#include "core/analysis/circularity/test_program.h"
#include "core/analysis/notes/remarks.h"
#include "core/analysis/run/run_stages.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/export/circular.h"
#ifdef FEEDSCOPE_WITH_UI
#include "app/commands/language_option.h"
#include "app/picture_size.h"
#include "ui/window/panels/pictures_of_panels.h"
#endif

namespace feedscope {
namespace {

struct CircularOptions {
  RunOptions run;                  ///< program, and setup of a test
  std::vector<std::string> radii;  ///< as typed [mm]
  std::vector<std::string> feeds;  ///< [mm/min]
  std::string plane;
  std::string start;         ///< [degrees]
  std::string sweep;         ///< [degrees]
  std::string entry_radius;  ///< [mm]
  std::string json, csv, program;
  std::string out, size;
  std::string language;              ///< of the picture
  std::vector<std::string> circles;  ///< of a program, to be drawn: numbers from 1, as typed

  bool of_program() const { return !run.file.empty(); }
};

/// `text`, or `usual` if nothing was typed.
std::string typed_or(const std::string& text, const char* usual) {
  return text.empty() ? usual : text;
}

/// Number of a circle of the program, from 1. Throws InputError if `text` is not a number up to `most`.
std::size_t circle_number(const std::string& text, std::size_t most) {
  SettingSpec bounds = whole_numbers(1, static_cast<double>(most));
  bounds.key = "--circle";
  return static_cast<std::size_t>(std::get<double>(parse_setting(bounds, text)));
}

/// Throws InputError if options of a test and of a program are mixed, or neither are given.
void check_form(const CircularOptions& options) {
  std::vector<GivenOption> other;
  if (options.of_program()) {
    other = {{"--radius", !options.radii.empty()},   {"--feed", !options.feeds.empty()},
             {"--plane", !options.plane.empty()},    {"--start", !options.start.empty()},
             {"--sweep", !options.sweep.empty()},    {"--entry-radius", !options.entry_radius.empty()},
             {"--program", !options.program.empty()}};
    for (const auto& [name, given] : other) {
      if (given) {
        throw InputError(
            fmt::format("{} describes a circle to be tested, but '{}' is a program whose own circles are "
                        "evaluated; omit one",
                        name, options.run.file));
      }
    }
    if (!options.circles.empty() && options.out.empty()) {
      throw InputError("--circle says which circles --out draws; give --out FILE.png too");
    }
    for (const std::string& circle : options.circles) {
      circle_number(circle, std::numeric_limits<std::uint32_t>::max());
    }
    return;
  }
  other = given_of(options.run);
  other.emplace_back("--circle", !options.circles.empty());
  for (const auto& [name, given] : other) {
    if (given && !(std::string_view(name) == "--dialect" && !options.program.empty())) {
      throw InputError(
          std::string_view(name) == "--dialect"
              ? std::string("--dialect needs --program FILE, or a program to be read")
              : fmt::format("{} needs a program whose circles are evaluated; give one, or omit it", name));
    }
  }
  for (const auto& [name, missing] :
       {GivenOption("--radius", options.radii.empty()), {"--feed", options.feeds.empty()}}) {
    if (missing) {
      throw InputError(
          fmt::format("no circle to evaluate: {} is missing; give --radius MM and --feed MM_MIN, "
                      "or a program with full circles",
                      name));
    }
  }
}

double number(const std::string& text, std::string option, std::string unit, double least, double most) {
  SettingSpec spec;
  spec.key = std::move(option);
  spec.unit = std::move(unit);
  spec.minimum = least;
  spec.maximum = most;
  return std::get<double>(parse_setting(spec, text));
}

std::vector<CircularRequest> requests_of(const CircularOptions& options) {
  constexpr double largest_radius = 1e5;  // [mm]
  constexpr double largest_feed = 1e6;    // [mm/min]
  CircularRequest common;
  common.plane = parse_plane(typed_or(options.plane, "XY"));
  common.start = units::from_deg(number(typed_or(options.start, "0"), "--start", "degrees", -360, 360));
  common.sweep = units::from_deg(number(typed_or(options.sweep, "360"), "--sweep", "degrees", 1, 360));
  if (!options.entry_radius.empty()) {
    common.entry_radius = number(options.entry_radius, "--entry-radius", "mm", 1e-3, largest_radius);
  }
  std::vector<CircularRequest> requests;
  for (const std::string& radius : options.radii) {
    for (const std::string& feed : options.feeds) {
      CircularRequest request = common;
      request.radius = number(radius, "--radius", "mm", 1e-3, largest_radius);
      request.feed = units::from_mm_min(number(feed, "--feed", "mm/min", 1e-3, largest_feed));
      requests.push_back(request);
    }
  }
  return requests;
}

/// Writes the requested files: `json` and `csv` make the texts, `tests` are drawn.
template <class Json, class Csv>
void write_outputs(const CircularOptions& options, [[maybe_unused]] const Setup& setup, Json json, Csv csv,
                   [[maybe_unused]] const std::vector<CircularTest>& tests, const std::string& program) {
  OutputFiles files;
  if (!options.json.empty()) {
    files.add(options.json) << json();
  }
  if (!options.csv.empty()) {
    files.add(options.csv) << csv();
  }
  if (!options.program.empty()) {
    files.add(options.program) << program;
  }
#ifdef FEEDSCOPE_WITH_UI
  if (!options.out.empty()) {
    const auto size =
        options.size.empty() ? std::optional<ui::PictureSize>() : parse_picture_size(options.size);
    files.add(options.out) << ui::circular_file(options.out, setup, tests, size,
                                                QString::fromStdString(options.language));
  }
#endif
  files.commit();
}

bool to_standard_output(const CircularOptions& options) {
  return options.json == "-" || options.csv == "-" || options.program == "-";
}

int circular_test(const CircularOptions& options) {
  const std::vector<CircularRequest> requests = requests_of(options);
  check_outputs("", {options.json, options.csv, options.program, options.out});
  const Setup setup = make_setup(options.run.request(Dialect::iso));
  std::vector<CircularTest> tests;
  {
    Watch watch;
    for (const CircularRequest& request : requests) {
      tests.push_back(run_circular_test(request, setup, watch.stage("simulating circles")));
    }
  }
  const std::string program =
      options.program.empty() ? std::string()
                              : test_program(requests, dialect_of_id(typed_or(options.run.dialect, "fanuc")));
  write_outputs(
      options, setup, [&] { return circular_json(setup, tests); }, [&] { return circular_csv(tests); }, tests,
      program);
  for (const Message& note : drive_remarks(setup.machine)) {
    fmt::print(stderr, "feedscope: note: {}\n", note.english());
  }
  if (!to_standard_output(options)) {
    fmt::print("{}", circular_text(setup, tests));
  }
  return exit_code::done;
}

/// The circles to draw. Throws InputError for a number without a circle, and if there is nothing to draw.
std::vector<CircularTest> drawn(const CircularOptions& options, const ProgramCircles& circles) {
  constexpr std::size_t usual = 4;
  if (options.out.empty()) {
    return {};
  }
  if (circles.tests.empty()) {
    throw InputError(fmt::format("--out '{}' cannot be drawn: {}", options.out,
                                 program_circle_notes(circles).front().english()));
  }
  std::vector<CircularTest> tests;
  for (const std::string& text : options.circles) {
    tests.push_back(circles.tests[circle_number(text, circles.tests.size()) - 1]);
  }
  if (tests.empty()) {
    tests.assign(circles.tests.begin(),
                 circles.tests.begin() + static_cast<std::ptrdiff_t>(std::min(usual, circles.tests.size())));
    if (circles.tests.size() > usual) {
      fmt::print(stderr, "feedscope: note: the first {} of {} circles are drawn; --circle N selects others\n",
                 usual, circles.tests.size());
    }
  }
  return tests;
}

int circles_of_program(const CircularOptions& options) {
  const AskedProgram asked = asked_program(options.run, given_of_run(options.run));
  const Setup setup =
      asked.is_session() ? asked.setups[asked.current] : make_setup(options.run.request(asked.dialect()));
  for (const std::string& input : {options.run.file, asked.file}) {
    check_outputs(input, {options.json, options.csv, options.out});
  }
  Run run;
  ProgramCircles circles;
  {
    Watch watch;
    const LoadedProgram program =
        load_program(asked.source, watch.stage("reading"), reading_on(asked.reading, setup.machine));
    run = simulate_motion(program, setup, watch.stage("simulating"));
    circles = program_circles(run, watch.stage("evaluating circles"));
  }
  write_outputs(
      options, setup, [&] { return program_circles_json(setup, *run.input.program, circles); },
      [&] { return program_circles_csv(circles); }, drawn(options, circles), {});
  tell_of_run(run, options.run, asked.reading);
  if (!to_standard_output(options)) {
    fmt::print("{}", program_circles_text(run, circles));
  }
  return exit_code_of(run);
}

int circular(const CircularOptions& options) {
  check_form(options);
  return options.of_program() ? circles_of_program(options) : circular_test(options);
}

}  // namespace

Command add_circular_command(CLI::App& app) {
  const auto options = std::make_shared<CircularOptions>();
  CLI::App* command = app.add_subcommand(
      "circular",
      "Simulate a circular test (ISO 230-4) in both directions, or evaluate the full circles of a program: "
      "circularity and radial errors");
  add_run_options(*command, options->run)
      ->required(false)
      ->description(
          "NC program, or a session (.feedscope), whose full circles are evaluated; - for standard "
          "input. Without it: --radius and --feed");
  command
      ->add_option("--radius", options->radii, "Radius in mm of a circle to be tested; several make a table")
      ->type_name("MM")
      ->allow_extra_args(false);
  command->add_option("--feed", options->feeds, "Its programmed feed in mm/min; several make a table")
      ->type_name("MM_MIN")
      ->allow_extra_args(false);
  command->add_option("--plane", options->plane, "Plane of the circle: XY, ZX or YZ [XY]")
      ->type_name("PLANE");
  command->add_option("--start", options->start, "Angle of the start from the first axis in degrees [0]")
      ->type_name("DEG");
  command->add_option("--sweep", options->sweep, "Angle of the arc in degrees [360]")->type_name("DEG");
  command
      ->add_option(
          "--entry-radius", options->entry_radius,
          "Radius in mm of a quarter circle that leads in, and of one that leads out [from rest to rest]")
      ->type_name("MM");
  command->add_option("--json", options->json, "Write the results; - for standard output")->type_name("FILE");
  command->add_option("--csv", options->csv, "Write the results as a table; - for standard output")
      ->type_name("FILE");
  command
      ->add_option("--program", options->program,
                   "Write the NC program of the test for the real machine; - for standard output")
      ->type_name("FILE");
#ifdef FEEDSCOPE_WITH_UI
  CLI::Option* out = command->add_option("--out", options->out, "Draw the tests as polar plots")
                         ->type_name("FILE.png|svg|pdf");
  command->add_option("--size", options->size, "Width and height of the picture [as large as the plots need]")
      ->type_name("WxH")
      ->needs(out);
  add_language_option(*command, options->language);
  command->get_option("--language")->needs(out);
  command
      ->add_option("--circle", options->circles,
                   "Number in the table of a circle of the program that --out draws; repeat for more [the "
                   "first four]")
      ->type_name("N")
      ->allow_extra_args(false);
#endif
  command->get_option("--dialect")
      ->description(fmt::format("{}; of the one that --program writes [fanuc]",
                                command->get_option("--dialect")->get_description()));
  state_number_rule(*command);
  return {command, [options] {
            move_tolerance(options->run);
            return circular(*options);
          }};
}

}  // namespace feedscope
