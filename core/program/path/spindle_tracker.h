#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/program/spindle_state.h"
#include "core/program/text/diagnostic_log.h"

namespace feedscope {

/// Current state of the spindle, and the table of its states to which motions point.
class SpindleTracker {
 public:
  /// `states` outlives it and gets its first one; `log` outlives it.
  SpindleTracker(std::vector<SpindleState>& states, DiagnosticLog& log);

  /// Index into Program::tools; -1: none.
  void set_tool(std::int32_t tool) { tool_ = tool; }
  void set_stands(bool stands) { stands_ = stands; }
  /// G96: constant cutting speed.
  void set_surface_speed(bool on) { surface_speed_ = on; }

  /// State for a motion that begins now; `speed` [1/s]. Returns the first, unknown state, with a report at
  /// `place`, if there are more states than a motion can point to.
  std::uint16_t index(double speed, const DiagnosticLog::Place& place);

 private:
  std::vector<SpindleState>& states_;
  DiagnosticLog& log_;
  std::int32_t tool_ = -1;
  bool stands_ = false;
  bool surface_speed_ = false;
  std::uint16_t last_ = 0;
  std::map<SpindleState, std::uint16_t> indices_;
};

}  // namespace feedscope
