#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/program/sinumerik/context.h"

namespace feedscope::sinumerik {

/// Words of axes other than X, Y and Z, which are not simulated: rotary and secondary axes, tool orientation.
/// Passes each one that moves on to OtherAxes.
class OtherAxisWords : private Part {
 public:
  explicit OtherAxisWords(Context& context) : Part(context) {}

  /// True for angles that turn the tool, and components of the vectors that give its direction: "A3", "LEAD".
  static bool is_orientation(std::string_view name);

  /// TRAORI and TRAFOOF: whether X, Y and Z are those of the tool's tip. ORIVECT, ORIPLANE and ORIAXES:
  /// whether its direction follows great circles or the axes go linearly.
  void follow(const Function& function) {
    oriented_ = (oriented_ || function.name == "TRAORI") && function.name != "TRAFOOF";
    const bool vector = function.name == "ORIVECT" || function.name == "ORIPLANE";
    great_circle_ = (great_circle_ || vector) && function.name != "ORIAXES";
  }
  void begin_block() { named_.clear(); }
  /// Moves the axis to `value`, [mm] or [deg], with the block; does nothing if it is there.
  void move(std::string_view name, const BlockWords::Value& value) { named_.emplace_back(name, value); }
  /// Runs A, B, C, U, V, W of the block and the axes of move(); `own`: the block's coordinates are not a
  /// motion.
  void run(bool own);

 private:
  /// A3, B3, C3 under TRAORI: the tool's direction; missing ones are zero. False if the block has none that
  /// is simulated.
  bool orient(bool alone);
  void go(const std::string& name, const BlockWords::Value& value, bool alone);

  std::map<std::string, double> places_;                          ///< by upper-case name
  std::vector<std::pair<std::string, BlockWords::Value>> named_;  ///< of the block
  bool oriented_ = false;
  bool great_circle_ = false;
};

}  // namespace feedscope::sinumerik
