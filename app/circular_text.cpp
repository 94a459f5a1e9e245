#include "app/circular_text.h"

#include <fmt/format.h>

#include <cmath>

#include "app/print.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

std::string micrometres(double length) {
  return fmt::format("{:.2f}", std::round(100 * units::to_um(length)) / 100 + 0.0);
}

std::string micrometres(const std::optional<double>& length) {
  return length ? micrometres(*length) : std::string("-");
}

std::string millimetres(double length) {
  return fmt::format("{:.6g}", std::round(1e4 * length) / 1e4 + 0.0);
}

std::string feed(double value) {
  return fmt::format("{:.1f}", units::to_mm_min(value));
}

std::string lines(const CirclePass& pass) {
  return pass.first_line == pass.last_line ? fmt::format("{}", pass.first_line)
                                           : fmt::format("{}-{}", pass.first_line, pass.last_line);
}

std::string path_text(bool actual) {
  return actual ? "actual path of the axes" : "set path; the machine has no drives: give X.kv and its kin";
}

constexpr const char* letters =
    "G: least separation of two concentric circles that hold the path; G ls: the same about the\n"
    "centre of the least-squares circle; Fmax, Fmin: largest and least deviation from the nominal\n"
    "radius at the programmed centre; G(b): G of both directions together; D: mean radius of both\n"
    "directions less the nominal one (ISO 230-4). All in um.\n";

}  // namespace

std::string circular_text(const Setup& setup, std::span<const CircularTest> tests) {
  TextTable table;
  table.add(
      {"radius mm", "feed mm/min", "reached", "", "time s", "G um", "G ls", "Fmax", "Fmin", "G(b)", "D"});
  for (const CircularTest& test : tests) {
    for (const CirclePass& pass : test.passes) {
      const Circularity& found = pass.circularity;
      table.add({fmt::format("{:.6g}", test.request.radius),
                 fmt::format("{:.6g}", units::to_mm_min(test.request.feed)), feed(pass.reached_feed),
                 pass.direction(), fmt::format("{:.3f}", pass.time), micrometres(found.zone),
                 micrometres(found.by_squares), micrometres(found.largest), micrometres(found.smallest),
                 micrometres(test.g_b()), micrometres(test.d())});
    }
  }
  return fmt::format("{}, model {}: {}\n\n{}\n{}", setup.machine.name, setup.model->info().id,
                     path_text(tests.front().actual), table.text("rrrlrrrrrrr"), letters);
}

std::string program_circles_text(const Run& run, const ProgramCircles& circles) {
  std::string text =
      fmt::format("{} on {}, model {}: {}\n", run.input.program->source->name(), run.setup.machine.name,
                  run.setup.model->info().id, path_text(circles.actual));
  if (!circles.tests.empty()) {
    TextTable table;
    table.add({"no.", "line", "centre X, Y, Z mm", "", "radius mm", "feed mm/min", "reached", "", "angle",
               "G um", "G ls", "Fmax", "Fmin", "Fmean", "G(b)", "D"});
    std::size_t number = 0;
    for (const CircularTest& test : circles.tests) {
      ++number;
      for (const CirclePass& pass : test.passes) {
        const Circularity& found = pass.circularity;
        table.add({fmt::format("{}", number), lines(pass),
                   fmt::format("{}, {}, {}", millimetres(test.center.x()), millimetres(test.center.y()),
                               millimetres(test.center.z())),
                   std::string(info_of(test.request.plane).name), millimetres(test.request.radius),
                   fmt::format("{:.6g}", units::to_mm_min(test.request.feed)), feed(pass.reached_feed),
                   pass.direction(), fmt::format("{:.1f}", units::to_deg(pass.evaluated)),
                   micrometres(found.zone), micrometres(found.by_squares), micrometres(found.largest),
                   micrometres(found.smallest), micrometres(test.mean_deviation(pass)),
                   micrometres(test.g_b()), micrometres(test.d())});
      }
    }
    text += "\n" + table.text("rllrrrrlrrrrrrrr") + "\n" + letters;
    text +=
        "angle: evaluated, in degrees, from where the control has reached the circle to where it leaves\n"
        "it; Fmean: mean deviation of one direction. Centre and radius are those of the tool centre.\n";
  }
  for (const Message& note : program_circle_notes(circles)) {
    text += "\n" + wrapped(note.english(), 0) + "\n";
  }
  return text;
}

}  // namespace feedscope
