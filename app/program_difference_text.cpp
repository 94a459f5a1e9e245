#include "app/program_difference_text.h"

#include <fmt/format.h>

#include <cmath>

#include "app/print.h"
#include "core/analysis/notes/refused_lines.h"
#include "core/base/clock_text.h"

namespace feedscope {
namespace {

constexpr std::size_t most_difference_rows = 20;

/// "-12.345 s": less time in the new program.
std::string change(double old, double now) {
  return signed_text(now - old, 3) + " s";
}

std::string difference_millimetres(double length) {
  return fmt::format("{:.1f} mm", length);
}

std::string lines(const StretchSide& side) {
  return side.first_line == 0                ? "-"
         : side.first_line == side.last_line ? fmt::format("{}", side.first_line)
                                             : fmt::format("{}-{}", side.first_line, side.last_line);
}

std::string sums_text(const ProgramDifference& difference) {
  TextTable table;
  table.add({"", "stretches", "old path", "new path", "old time", "new time", "change"});
  for (std::size_t i = 0; i < program_change_count; ++i) {
    const ProgramDifference::Sum& sum = difference.sums[i];
    if (sum.count > 0) {
      table.add({std::string(program_change_title(static_cast<ProgramChange>(i))),
                 fmt::format("{}", sum.count), difference_millimetres(sum.old.length),
                 difference_millimetres(sum.now.length), seconds_text(sum.old.time),
                 seconds_text(sum.now.time), change(sum.old.time, sum.now.time)});
    }
  }
  return table.text("lrrrrrr");
}

std::string stretches_text(const ProgramDifference& difference) {
  TextTable table;
  table.add({"old lines", "new lines", "", "old time", "new time", "change"});
  const std::vector<std::size_t> places = largest_changes(difference, most_difference_rows);
  for (const std::size_t i : places) {
    const ProgramStretch& stretch = difference.stretches[i];
    table.add({lines(stretch.old), lines(stretch.now), std::string(program_change_title(stretch.change)),
               seconds_text(stretch.old.time), seconds_text(stretch.now.time),
               change(stretch.old.time, stretch.now.time)});
  }
  return places.empty() ? "Nowhere.\n" : table.text("lllrrr");
}

}  // namespace

std::string program_difference_text(const Run& old, const Run& now, const ProgramDifference& difference) {
  std::string text =
      fmt::format("{} instead of {}, on {} ({}), model {}\n\n", now.input.program->source->name(),
                  old.input.program->source->name(), now.setup.machine.name, now.setup.machine.control,
                  now.setup.model->info().id);
  bool refused = false;
  for (const Run* run : {&old, &now}) {
    if (is_refused(*run)) {
      refused = true;
      text += fmt::format("The control refuses {}: none of its feed motions is run.\n",
                          run->input.program->source->name());
    }
  }
  if (refused) {
    return text + "There is nothing to compare.\n";
  }
  const double before = old.summary.cycle_time;
  const double after = now.summary.cycle_time;
  const std::string share =
      before > 0 ? fmt::format(" ({} %)", signed_text(100 * (after / before - 1), 1)) : std::string();
  text += wrapped(fmt::format("{} instead of {}: {}{}. {:.1f} % of the new path is in the old program too. "
                              "Max. contour error {:.4f} mm instead of {:.4f} mm.",
                              time_text(after), time_text(before), change(before, after), share,
                              100 * difference.same_share(), now.summary.cutting_contour_error,
                              old.summary.cutting_contour_error),
                  0);
  text += "\n\nWhat became of the path\n" + sums_text(difference);
  text += "\nWhere the times differ most\n" + stretches_text(difference);
  return text;
}

}  // namespace feedscope
