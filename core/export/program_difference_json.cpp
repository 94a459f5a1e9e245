#include <algorithm>
#include <numeric>
#include <vector>

#include "core/analysis/difference/program_difference.h"
#include "core/analysis/notes/refused_lines.h"
#include "core/export/export.h"
#include "core/export/json_parts.h"

namespace feedscope {
namespace {

constexpr std::size_t most_stretches = 1000;

Json program_json(const Run& run) {
  const auto figure = [refused = is_refused(run)](double value) { return refused ? Json() : finite(value); };
  return {{"file", run.input.program->source->name()},
          {"lines", run.input.program->source->line_count()},
          {"segments", run.path->segments.size()},
          {"path_mm", finite(run.path->length())},
          {"cycle_time_s", figure(run.summary.cycle_time)},
          {"programmed_time_s", figure(run.summary.programmed_time)},
          {"max_contour_error_mm", figure(run.summary.max_contour_error)}};
}

Json lines_json(const StretchSide& side) {
  return side.first_line == 0 ? Json() : Json{{"first", side.first_line}, {"last", side.last_line}};
}

Json sides_json(const StretchSide& old, const StretchSide& now) {
  return {{"old_s", finite(old.time)},
          {"new_s", finite(now.time)},
          {"gained_s", finite(old.time - now.time)},
          {"old_mm", finite(old.length)},
          {"new_mm", finite(now.length)}};
}

Json sums_json(const ProgramDifference& difference) {
  Json list = Json::array();
  for (std::size_t i = 0; i < program_change_count; ++i) {
    const ProgramDifference::Sum& sum = difference.sums[i];
    Json entry{{"change", program_change_key(static_cast<ProgramChange>(i))}, {"stretches", sum.count}};
    entry.update(sides_json(sum.old, sum.now));
    list.push_back(std::move(entry));
  }
  return list;
}

/// Stretches with the largest differences, in the order of the programs.
Json stretches_json(const ProgramDifference& difference) {
  Json list = Json::array();
  for (const std::size_t i : largest_changes(difference, most_stretches)) {
    const ProgramStretch& stretch = difference.stretches[i];
    Json entry{{"change", program_change_key(stretch.change)},
               {"old_lines", lines_json(stretch.old)},
               {"new_lines", lines_json(stretch.now)}};
    entry.update(sides_json(stretch.old, stretch.now));
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace

std::string program_difference_json(const Run& old, const Run& now, const ProgramDifference& difference) {
  Json json = with_format("program-difference");
  json["old"] = program_json(old);
  json["new"] = program_json(now);
  json["machine"] = {{"id", now.setup.machine.id}, {"name", now.setup.machine.name}};
  json["model"] = now.setup.model->info().id;
  json["settings"] = settings_values(now.setup.settings);
  const bool refused = is_refused(old) || is_refused(now);
  json["gained_s"] = refused ? Json() : finite(old.summary.cycle_time - now.summary.cycle_time);
  json["same_share"] = finite(difference.same_share());
  json["by_change"] = sums_json(difference);
  json["stretches"] = stretches_json(difference);
  return text_of(json);
}

}  // namespace feedscope
