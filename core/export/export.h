#pragma once

#include <iosfwd>
#include <string>

#include "core/analysis/program_facts.h"
#include "core/analysis/summary.h"
#include "core/machine/machine.h"
#include "core/models/control_model.h"
#include "core/program/program.h"

namespace feedscope {

/// Samples as CSV, columns of DESIGN section 4; one row each `step` [s] and one for the very end.
void write_csv(std::ostream& out, const Trajectory& trajectory, double step, Progress* progress = nullptr);
/// Corner blends as CSV, columns of DESIGN section 4.
void write_blends(std::ostream& out, const Trajectory& trajectory);

/// What write_json reports.
struct Report {
  const Program& program;
  const Toolpath& toolpath;
  const Machine& machine;
  const ModelInfo& model;
  const Settings& settings;
  const Summary& summary;
  double read_time = 0;      ///< wall clock [s]
  double simulate_time = 0;  ///< wall clock [s]
};

/// The run as JSON, keys of DESIGN section 4, indented, newline at the end.
std::string simulation_json(const Report& report);

/// What `check` found as JSON: program{file, lines, blocks, segments, arcs, dwells, path_mm, rapid_mm,
/// dwell_s, feed_mm_min{min, max}, bounds} and diagnostics as in simulation_json.
std::string check_json(const Program& program, const ProgramFacts& facts);

}  // namespace feedscope
