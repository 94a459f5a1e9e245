#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace feedscope {

/// Side of the cut: a chip begins thin with `up` (conventional), thick with `down` (climb).
enum class Milling : std::uint8_t { up, down };

/// Lines of a program, inclusive, 1-based.
struct ProgramLines {
  std::uint32_t first = 1;
  std::uint32_t last = 1;
  bool operator==(const ProgramLines&) const = default;
};

/// A tool and its engagement wherever the operation applies; changes of the engagement along the path are not
/// simulated. A cylindrical end mill with equal pitch, its axis along Z.
struct Engagement {
  std::string tool;                 ///< name in the program, written as CutterRadii::key; "": any
  std::vector<ProgramLines> lines;  ///< where it applies; empty: everywhere
  double diameter = 0;              ///< D [mm]
  int teeth = 1;                    ///< z
  double helix = 0;                 ///< beta [rad]
  double radial_depth = 0;          ///< a_e, > 0, at most D [mm]
  double axial_depth = 0;           ///< a_p, > 0 [mm]
  Milling milling = Milling::down;
  std::string material;                 ///< id
  std::optional<double> spindle_speed;  ///< used if the program has none [1/s]
  std::optional<double> least_chip;     ///< chip thickness below which the edge rubs without cutting [mm]
  // Permissible limits of tool and spindle:
  std::optional<double> max_force;   ///< of the peak force in the plane [N]
  std::optional<double> max_torque;  ///< mean over a revolution [N mm]
  std::optional<double> max_power;   ///< mean over a revolution [N mm/s]
  std::optional<double> max_chip;    ///< largest thickness [mm]

  bool operator==(const Engagement&) const = default;
};

/// Angles between which a tooth cuts, from the normal on the left of the feed, in the direction of the
/// spindle (M3): 0 is on the left, pi/2 in the direction of feed [rad].
struct Immersion {
  double from = 0;  ///< phi_st
  double to = 0;    ///< phi_ex
};
/// For up milling 0 to acos(1 - 2 a_e/D); for down milling pi minus that, to pi.
Immersion immersion(const Engagement& operation);

/// Parses ranges of lines such as "10-25, 40-52"; none for other text. An empty text gives no lines.
std::optional<std::vector<ProgramLines>> ranges_of(std::string_view text);
/// Inverse of ranges_of().
std::string ranges_text(const std::vector<ProgramLines>& ranges);

/// Problem with the numbers of an operation, with advice; empty if there is none.
Message operation_problem(const Engagement& operation);

/// Name of an operation in messages and tables: "tool 1", "tool 1, lines 10 to 20", "all tools".
Message describe(const Engagement& operation);

}  // namespace feedscope
