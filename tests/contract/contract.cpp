#include "tests/contract/contract.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>

#include "core/analysis/run/run.h"
#include "core/program/program.h"
#include "core/toolpath/machine_path.h"

namespace feedscope::contract {
namespace {

std::string text_of(const Case& example) {
  return fmt::format("{}\n", fmt::join(example.lines, "\n"));
}

std::vector<Finding> check_run(const MachinePath& path, const Inputs& inputs) {
  const Toolpath& toolpath = *path;
  const Trajectory run = inputs.model.simulate(path, inputs.machine, inputs.settings);
  const Guarantees promised = inputs.model.guarantees(inputs.settings);
  const double tolerance =
      inputs.settings.has("contour_tolerance_mm") ? inputs.settings.number("contour_tolerance_mm") : 0;
  const Motion motion(toolpath, run);
  const bool waits_only = std::ranges::all_of(toolpath.segments, [&](const Segment& segment) {
    return segment.kind == SegmentKind::dwell && toolpath.dwell_of(segment) == 0;
  });
  if (motion.parts().empty() && (promised.arcs_are_chords || waits_only)) {
    return {};  // no block makes a step or a chord, or nothing lasts
  }
  if (motion.parts().empty() && !toolpath.segments.empty()) {
    return {Finding{"time", "nothing moves"}};
  }
  std::vector<Finding> broken = check_limits(motion, promised, inputs.machine);
  for (const Result& result :
       {check_time(motion), check_finite(motion), check_summary(motion, inputs.machine),
        check_ends(motion, promised, inputs.machine), check_continuity(motion, promised),
        check_feed(motion, promised), check_stops(motion, promised, inputs.machine),
        check_contour(motion, promised, tolerance, inputs.machine), check_derivatives(motion),
        check_displacement(motion, promised, inputs.machine), check_path_lookup(motion),
        check_rotary(motion, promised, inputs.machine), check_again(motion, inputs),
        check_split(motion, promised, inputs), check_bound(motion, promised, inputs)}) {
    if (result) {
      broken.push_back(*result);
    }
  }
  return broken;
}

}  // namespace

std::vector<Finding> check_case(const Case& example) {
  try {
    const ReadProgram program =
        read_program(std::make_shared<const SourceText>(SourceText("program", text_of(example))), nullptr,
                     reading_on({}, example.machine));
    const ControlModel& model = find_model(example.model);
    const Settings settings = complete_settings(model, example.machine);
    const auto programmed = std::make_shared<const Toolpath>(build_toolpath(program));
    return check_run(on_machine(model.read(programmed, settings).path, example.machine, settings),
                     {model, example.machine, settings, programmed});
  } catch (const std::exception& error) {
    return {Finding{"throws", error.what()}};
  }
}

Result finding_of(const std::vector<Finding>& findings, const std::string& check) {
  const auto found =
      std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.check == check; });
  return found == findings.end() ? Result() : Result(*found);
}

Case smallest(const Case& broken, const std::string& check) {
  constexpr int max_runs = 2000;
  Case best = broken;
  int runs = 0;
  for (std::size_t chunk = best.lines.size(); chunk > 0; chunk /= 2) {
    for (std::size_t first = 0; first < best.lines.size() && runs < max_runs;) {
      Case fewer = best;
      const auto begin = fewer.lines.begin() + static_cast<std::ptrdiff_t>(first);
      const std::size_t count = std::min(chunk, best.lines.size() - first);
      fewer.lines.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
      ++runs;
      if (finding_of(check_case(fewer), check)) {
        best = std::move(fewer);
      } else {
        first += chunk;
      }
    }
  }
  return best;
}

std::string report(const Case& broken, const Finding& finding, const std::filesystem::path& folder,
                   const std::string& name) {
  std::filesystem::create_directories(folder);
  const std::filesystem::path program = folder / (name + ".nc");
  const std::filesystem::path machine = folder / (name + ".toml");
  std::ofstream(program) << text_of(broken);
  std::ofstream(machine) << write_machine(broken.machine);
  constexpr std::size_t shown = 20;
  return fmt::format("{} breaks '{}': {}\n{} blocks{}\nfeedscope simulate {} --machine {} --model {}\n",
                     broken.model, finding.check, finding.detail, broken.lines.size(),
                     broken.lines.size() <= shown ? ":\n" + text_of(broken) : "", program.string(),
                     machine.string(), broken.model);
}

}  // namespace feedscope::contract
