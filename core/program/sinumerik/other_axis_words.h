#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "core/program/sinumerik/context.h"

namespace feedscope::sinumerik {

/// Words of axes other than X, Y and Z, which are not simulated: rotary and secondary axes, tool orientation.
/// Each one that moves is passed on to OtherAxes.
class OtherAxisWords : private Part {
 public:
  explicit OtherAxisWords(Context& context) : Part(context) {}

  /// Angles that turn the tool, and components of the vectors that give its direction: "A3", "LEAD".
  static bool is_orientation(std::string_view name);

  /// TRAORI and TRAFOOF: whether X, Y and Z are those of the tool's tip.
  void follow(const Function& function) {
    oriented_ = (oriented_ || function.name == "TRAORI") && function.name != "TRAFOOF";
  }
  /// The axis goes to `value`, [mm] or [deg]; nothing if it is there.
  void move(std::string_view name, std::uint32_t column, double value);
  /// A, B, C, U, V, W of the block.
  void run();

 private:
  std::map<std::string, double> places_;  ///< by upper-case name
  bool oriented_ = false;
};

}  // namespace feedscope::sinumerik
