#pragma once

#include <string>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/language/values.h"
#include "core/program/tools/cutter_radii.h"

namespace feedscope::sinumerik {

/// The tool and its cutter radius compensation: T, D, $TC_DP6, G40 to G42, G450, G451.
class Compensation : private Part {
 public:
  /// Both outlive it.
  Compensation(Context& context, Values& values) : Part(context), values_(values) {}

  /// Reads "$TC_DP6[tool, edge]=radius" after its name. Throws ReadFault.
  void set_tool_radius(Scanner& scanner);
  /// Selects a tool, by number or name.
  void choose_tool(const std::string& name);
  /// Number or name; empty: none yet.
  const std::string& tool() const { return modes_.tool; }
  /// G451: around outside corners to the meeting point of the paths; else G450.
  void set_corner_meeting(bool on) { modes_.corner_meeting = on; }
  /// Applies T, D, plane and G words of the block.
  void run();

  /// Modal state.
  struct Modes {
    std::string tool;
    double edge = 1;                 ///< D
    const Function* side = nullptr;  ///< G41, G42; nullptr: off
    bool corner_meeting = false;
  };
  const Modes& modes() const { return modes_; }
  void restore(const Modes& modes) { modes_ = modes; }

 private:
  void begin(std::uint32_t column);
  void report_radius(const std::string& cutter, std::uint32_t column) const;

  Values& values_;
  Modes modes_;
  CutterRadii radii_;  ///< set by the program
};

}  // namespace feedscope::sinumerik
