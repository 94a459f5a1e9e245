#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/number_option.h"
#include "app/output_file.h"
#include "app/print.h"
#include "app/run_options.h"
#include "app/watch.h"
#include "core/analysis/circularity/circular_test.h"
#include "core/analysis/circularity/test_program.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/export/circular.h"
#ifdef FEEDSCOPE_WITH_UI
#include "app/picture_size.h"
#include "ui/window/pictures_of_panels.h"
#endif

namespace feedscope {
namespace {

struct CircularOptions {
  std::vector<std::string> radii;  ///< as typed [mm]
  std::vector<std::string> feeds;  ///< [mm/min]
  std::string plane = "XY";
  std::string start = "0";    ///< [degrees]
  std::string sweep = "360";  ///< [degrees]
  std::string entry_radius;   ///< [mm]
  std::string machine, model, tolerance;
  std::vector<std::string> set;
  std::string json, csv, program;
  std::string out, size;
  std::string dialect = "fanuc";
};

double number(const std::string& text, const char* option, const char* unit, double least, double most) {
  SettingSpec spec;
  spec.key = option;
  spec.unit = unit;
  spec.minimum = least;
  spec.maximum = most;
  return std::get<double>(parse_setting(spec, text));
}

std::vector<CircularRequest> requests_of(const CircularOptions& options) {
  constexpr double largest_radius = 1e5;  // [mm]
  constexpr double largest_feed = 1e6;    // [mm/min]
  CircularRequest common;
  common.plane = parse_plane(options.plane);
  common.start = units::from_deg(number(options.start, "--start", "degrees", -360, 360));
  common.sweep = units::from_deg(number(options.sweep, "--sweep", "degrees", 1, 360));
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

std::string micrometres(double length) {
  return fmt::format("{:.2f}", std::round(100 * units::to_um(length)) / 100 + 0.0);
}

std::string table_of(const std::vector<CircularTest>& tests) {
  TextTable table;
  table.add(
      {"radius mm", "feed mm/min", "reached", "", "time s", "G um", "G ls", "Fmax", "Fmin", "G(b)", "D"});
  for (const CircularTest& test : tests) {
    for (const CirclePass& pass : test.passes) {
      const Circularity& found = pass.circularity;
      table.add({fmt::format("{:.6g}", test.request.radius),
                 fmt::format("{:.6g}", units::to_mm_min(test.request.feed)),
                 fmt::format("{:.1f}", units::to_mm_min(pass.reached_feed)), pass.direction(),
                 fmt::format("{:.3f}", pass.time), micrometres(found.zone), micrometres(found.by_squares),
                 micrometres(found.largest), micrometres(found.smallest), micrometres(test.g_b()),
                 micrometres(test.d())});
    }
  }
  return table.text("rrrlrrrrrrr");
}

void write_outputs(const CircularOptions& options, const Setup& setup,
                   const std::vector<CircularRequest>& requests, const std::vector<CircularTest>& tests) {
  OutputFiles files;
  if (!options.json.empty()) {
    files.add(options.json) << circular_json(setup, tests);
  }
  if (!options.csv.empty()) {
    files.add(options.csv) << circular_csv(tests);
  }
  if (!options.program.empty()) {
    files.add(options.program) << test_program(requests, dialect_of_id(options.dialect));
  }
#ifdef FEEDSCOPE_WITH_UI
  if (!options.out.empty()) {
    const auto size =
        options.size.empty() ? std::optional<ui::PictureSize>() : parse_picture_size(options.size);
    files.add(options.out) << ui::circular_file(options.out, setup, tests, size);
  }
#endif
  files.commit();
}

int circular(const CircularOptions& options) {
  const std::vector<CircularRequest> requests = requests_of(options);
  check_outputs("", {options.json, options.csv, options.program, options.out});
  SetupRequest asked{options.machine, options.model, {}, options.set, Dialect::iso};
  if (!options.tolerance.empty()) {
    asked.tolerance = parse_tolerance(options.tolerance);
  }
  const Setup setup = make_setup(asked);
  std::vector<CircularTest> tests;
  {
    Watch watch;
    for (const CircularRequest& request : requests) {
      tests.push_back(run_circular_test(request, setup, watch.stage("simulating circles")));
    }
  }
  write_outputs(options, setup, requests, tests);
  if (options.json != "-" && options.csv != "-" && options.program != "-") {
    fmt::print("{}, model {}: {}\n\n{}", setup.machine.name, setup.model->info().id,
               tests.front().actual ? "actual path of the axes"
                                    : "set path; the machine has no drives: give X.kv and its kin",
               table_of(tests));
    fmt::print(
        "\nG: least separation of two concentric circles that hold the path; G ls: the same about the\n"
        "centre of the least-squares circle; Fmax, Fmin: largest and least deviation from the nominal\n"
        "radius at the programmed centre; G(b): G of both directions together; D: mean radius of both\n"
        "directions less the nominal one (ISO 230-4). All in um.\n");
  }
  return exit_code::done;
}

}  // namespace

Command add_circular_command(CLI::App& app) {
  const auto options = std::make_shared<CircularOptions>();
  CLI::App* command = app.add_subcommand(
      "circular", "Simulate a circular test (ISO 230-4) in both directions: circularity and radial errors");
  command->add_option("--radius", options->radii, "Radius in mm; several make a table")
      ->required()
      ->type_name("MM")
      ->allow_extra_args(false);
  command->add_option("--feed", options->feeds, "Programmed feed in mm/min; several make a table")
      ->required()
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
  command->add_option("--machine", options->machine, machine_help())->type_name("ID|FILE");
  command->add_option("--model", options->model, "Control model [the machine's]")->type_name("ID");
  command->add_option("--tolerance", options->tolerance, "Contour tolerance in mm [the machine's]")
      ->type_name("MM");
  add_set_option(*command, options->set);
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
#endif
  std::vector<std::string_view> dialects;
  for (const DialectInfo& info : all_dialects()) {
    dialects.push_back(info.id);
  }
  command
      ->add_option("--dialect", options->dialect,
                   fmt::format("Dialect of that program: {} [fanuc]", fmt::join(dialects, ", ")))
      ->needs("--program")
      ->type_name("ID");
  state_number_rule(*command);
  return {command, [options] { return circular(*options); }};
}

}  // namespace feedscope
