#pragma once

#include <string>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/values.h"
#include "core/program/tools/cutter_radii.h"

namespace feedscope::sinumerik {

/// The tool and its cutter radius compensation: T, D, $TC_DP6, G40 to G42, G450, G451.
class Compensation : private Part {
 public:
  /// Both outlive it.
  Compensation(Context& context, Values& values) : Part(context), values_(values) {}

  /// "$TC_DP6[tool, edge]=radius", whose name has just been read. Throws ReadFault.
  void set_tool_radius(Scanner& scanner);
  /// The program asks for a tool, by number or name.
  void choose_tool(const std::string& name);
  /// Number or name; empty: none yet.
  const std::string& tool() const { return modes_.tool; }
  /// G451: around outside corners to where the paths meet; else G450.
  void set_corner_meeting(bool on) { modes_.corner_meeting = on; }
  /// T, D, plane and G words of the block.
  void run();

  /// What stays in force.
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
  CutterRadii radii_;  ///< that the program sets
};

}  // namespace feedscope::sinumerik
