#include "app/merge_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "app/print.h"
#include "core/base/clock_text.h"

namespace feedscope {

namespace {

/// "2 errors, read in part", "no motion"; "" for a program without defects.
std::string defect_text(const MergedProgram& program) {
  const std::string errors = program.errors == 0 ? ""
                                                 : fmt::format("{} error{}, read in part", program.errors,
                                                               program.errors == 1 ? "" : "s");
  const std::string empty = program.segments == 0 ? "no motion" : "";
  return errors + (errors.empty() || empty.empty() ? "" : "; ") + empty;
}

std::string total_heading(const MergedComparison& merged) {
  std::vector<std::string> defects;
  for (const MergedProgram& program : merged.programs) {
    if (const std::string defect = defect_text(program); !defect.empty()) {
      defects.push_back(fmt::format("{}: {}", program.file, defect));
    }
  }
  const std::string title = fmt::format("All of {} programs", merged.programs.size());
  return defects.empty()
             ? title
             : fmt::format("{}, {} of them incomplete ({})", title, defects.size(), fmt::join(defects, ", "));
}

std::string fastest_text(const MergedComparison& merged) {
  if (!merged.within) {
    return "";
  }
  const MergedSum* best = merged.fastest_sum();
  if (best == nullptr && std::ranges::none_of(merged.sums, [&](const MergedSum& sum) {
        return sum.programs == merged.programs.size();
      })) {
    return fmt::format(
        "\nNo setting ran in all {} programs, so that none can be the fastest of all; run them on one "
        "machine with one model (--machine, --model).\n",
        merged.programs.size());
  }
  if (best == nullptr) {
    return fmt::format("\nNo value has a contour error within {} mm in all {} programs.\n", *merged.within,
                       merged.programs.size());
  }
  return fmt::format("\n* Fastest within {} mm. Of all {} programs: {} on {}, {}, {}.{}\n", *merged.within,
                     merged.programs.size(), best->run.model, best->run.machine, best->run.setting,
                     time_text(best->run.cycle_time), not_run_text(best->run.lines_not_run));
}

}  // namespace

std::string merge_text(const MergedComparison& merged) {
  TextTable table;
  table.add(
      {"", "machine", "model", "setting", "programs", "cycle time", "h:mm:ss", "mean feed", "contour error"});
  table.add({"", "", "", "", "", "[s]", "", "[mm/min]", "[mm]"});
  const auto add = [&](const MergedRun& run, std::size_t programs, bool has_feed, bool fastest) {
    if (run.refused) {
      table.add({"", run.machine, run.model, run.setting, fmt::format("{}", programs), refused_word, "-",
                 has_feed ? "-" : "", "-"});
      return;
    }
    table.add({fastest ? "*" : "", run.machine, run.model, run.setting, fmt::format("{}", programs),
               fmt::format("{:.3f}", run.cycle_time), clock_text(run.cycle_time),
               has_feed ? fmt::format("{:.1f}", run.mean_feed) : "",
               fmt::format("{:.4f}", run.cutting_contour_error)});
  };
  for (const MergedProgram& program : merged.programs) {
    const std::string defect = defect_text(program);
    table.add_heading(defect.empty() ? program.file : fmt::format("{} ({})", program.file, defect));
    const std::vector<bool> marks = merged.fastest(program);
    for (std::size_t i = 0; i < program.runs.size(); ++i) {
      add(program.runs[i], 1, true, marks[i]);
    }
  }
  table.add_heading(total_heading(merged));
  const std::vector<bool> marks = merged.fastest_sums();
  for (std::size_t i = 0; i < merged.sums.size(); ++i) {
    add(merged.sums[i].run, merged.sums[i].programs, false, marks[i]);
  }
  return table.text("llllrrrrr") + fastest_text(merged);
}

}  // namespace feedscope
