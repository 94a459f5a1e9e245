#include "app/merge_text.h"

#include <fmt/format.h>

#include "app/print.h"
#include "core/base/clock_text.h"

namespace feedscope {

std::string merge_text(const MergedComparison& merged) {
  TextTable table;
  table.add(
      {"machine", "model", "setting", "programs", "cycle time", "h:mm:ss", "mean feed", "contour error"});
  table.add({"", "", "", "", "[s]", "", "[mm/min]", "[mm]"});
  const auto add = [&](const MergedRun& run, std::size_t programs, bool has_feed) {
    table.add({run.machine, run.model, run.setting, fmt::format("{}", programs),
               fmt::format("{:.3f}", run.cycle_time), clock_text(run.cycle_time),
               has_feed ? fmt::format("{:.1f}", run.mean_feed) : "",
               fmt::format("{:.4f}", run.max_contour_error)});
  };
  for (const MergedProgram& program : merged.programs) {
    table.add_heading(program.file);
    for (const MergedRun& run : program.runs) {
      add(run, 1, true);
    }
  }
  table.add_heading(fmt::format("All of {} programs", merged.programs.size()));
  for (const MergedSum& sum : merged.sums) {
    add(sum.run, sum.programs, false);
  }
  return table.text("lllrrrrr");
}

}  // namespace feedscope
