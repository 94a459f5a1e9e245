#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace feedscope {

/// With the tool on which side of the cut: `up` (conventional) begins a chip thin, `down` (climb) thick.
enum class Milling : std::uint8_t { up, down };

/// Lines of a program, both included, from 1.
struct ProgramLines {
  std::uint32_t first = 1;
  std::uint32_t last = 1;
  bool operator==(const ProgramLines&) const = default;
};

/// A tool and how it is engaged wherever the operation applies; it is not simulated how the engagement
/// changes along the path. A cylindrical end mill with equal pitch, its axis along Z.
struct Engagement {
  std::string tool;                 ///< as the program calls it, written as CutterRadii::key; "": any
  std::vector<ProgramLines> lines;  ///< where it applies; none: everywhere
  double diameter = 0;              ///< D [mm]
  int teeth = 1;                    ///< z
  double helix = 0;                 ///< beta [rad]
  double radial_depth = 0;          ///< a_e, > 0 to D [mm]
  double axial_depth = 0;           ///< a_p, > 0 [mm]
  Milling milling = Milling::down;
  std::string material;                 ///< id
  std::optional<double> spindle_speed;  ///< where the program gives none [1/s]
  std::optional<double> least_chip;     ///< thickness below which the edge rubs and cuts no chip [mm]
  // Bounds of what is good for tool and spindle:
  std::optional<double> max_force;   ///< of the peak in the plane [N]
  std::optional<double> max_torque;  ///< mean over a revolution [N mm]
  std::optional<double> max_power;   ///< mean over a revolution [N mm/s]
  std::optional<double> max_chip;    ///< largest thickness [mm]

  bool operator==(const Engagement&) const = default;
};

/// The angles between which a tooth cuts, from the normal on the left of the feed, in the sense in which the
/// spindle turns (M3): 0 is on the left, pi/2 in the direction of feed [rad].
struct Immersion {
  double from = 0;  ///< phi_st
  double to = 0;    ///< phi_ex
};
/// Up: 0 to acos(1 - 2 a_e/D); down: pi minus that, to pi.
Immersion immersion(const Engagement& operation);

/// "10-25, 40-52" as ranges of lines; none for another text. An empty text is none of a program's lines.
std::optional<std::vector<ProgramLines>> ranges_of(std::string_view text);
/// The text that ranges_of() reads as these.
std::string ranges_text(const std::vector<ProgramLines>& ranges);

/// What is wrong with the numbers of an operation, with what to do; empty if nothing is.
Message operation_problem(const Engagement& operation);

/// "tool 1", "tool 1, lines 10 to 20", "all tools": how messages and tables name an operation.
Message describe(const Engagement& operation);

}  // namespace feedscope
