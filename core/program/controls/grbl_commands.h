#pragma once

#include <cstdint>
#include <optional>

#include "core/program/controls/grbl_line.h"

namespace feedscope {

/// Modal state of grbl.
struct GrblModes {
  int motion = 0;  ///< G0 to G3, G38 (probing), G80
  int plane = 17;
  bool incremental = false;
  bool inverse_time = false;
  bool inch = false;
  std::size_t offset = 0;  ///< of G54 to G59
  int spindle = 5;         ///< M3, M4, M5
  bool coolant = false;
};

/// Commands of a line.
struct GrblCommands {
  /// Command to which the axis words belong.
  enum class Axes : std::uint8_t { none, motion, set_offset, home, second_home, shift, tool_length };

  GrblModes modes;  ///< from this line on
  Axes axes = Axes::none;
  bool machine_place = false;  ///< G53
  bool dwell = false;          ///< G4
  bool save_home = false;      ///< G28.1
  bool save_second_home = false;
  bool clear_shift = false;     ///< G92.1
  bool no_tool_length = false;  ///< G49
  bool end = false;             ///< M2, M30
  bool stop = false;            ///< M0, M1
};

/// Finds the commands of `line` with `modes` in force; returns grbl's error if it rejects them.
std::optional<GrblError> find_grbl_commands(const GrblLine& line, const GrblModes& modes,
                                            GrblCommands& found);

}  // namespace feedscope
