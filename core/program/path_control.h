#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/program/text/diagnostic_log.h"

namespace feedscope {

/// Behaviour of a control where blocks meet.
enum class PathMode : std::uint8_t {
  machine,     ///< by machine file and model
  exact_stop,  ///< stops at the end of every block, but see PathControl::exact_path: G9, G60, G61, G61.1
  continuous,  ///< runs through: G64, G641 to G645, M120
};

/// Start of the next block after an exact stop: once every axis is within a window around its end, with sizes
/// from machine data, or as soon as the set speed is zero.
enum class ExactStopWindow : std::uint8_t {
  machine,
  fine,               ///< G601
  coarse,             ///< G602
  interpolation_end,  ///< G603
};

enum class AccelerationMode : std::uint8_t {
  machine,
  soft,   ///< jerk limited: SOFT
  brisk,  ///< acceleration steps: BRISK
  drive,  ///< acceleration that falls above a speed: DRIVE
};

enum class Switch : std::uint8_t { machine, on, off };

/// Execution of the path that the program requests, whatever the words of its dialect. The machine decides
/// everything left open. Every motion has one.
struct PathControl {
  PathMode mode = PathMode::machine;
  ExactStopWindow exact_stop_window = ExactStopWindow::machine;  ///< of mode exact_stop
  bool exact_path =
      false;  ///< of mode exact_stop: LinuxCNC does not stop between blocks that meet tangentially: G61
  /// Largest distance of the executed from the programmed path [mm]: CTOL, CYCLE832, G64 P, cycle 32 T.
  std::optional<double> contour_tolerance;
  /// Distance from a corner at which its blend may begin [mm]: ADIS, ADISPOS.
  std::optional<double> blend_distance;
  std::optional<double> orientation_tolerance;  ///< of the tool [rad]: OTOL, TA
  Switch compaction = Switch::machine;          ///< joins short blocks: COMPON, COMPCURV, COMPCAD, G64 Q
  /// Lays smooth curves through short blocks: COMPON, COMPCURV, COMPCAD, COMPSURF, CYCLE832, cycle 32, G5.1
  /// Q1.
  Switch compressor = Switch::machine;
  std::optional<double> compaction_tolerance;  ///< [mm]; none: the contour tolerance
  AccelerationMode acceleration = AccelerationMode::machine;
  Switch feed_forward = Switch::machine;  ///< FFWON, FFWOF
  Switch look_ahead = Switch::machine;    ///< G05.1, G08, G5 P10000; not G64 against G60

  bool operator==(const PathControl&) const = default;
};

/// True if a contour tolerance or blend distance [mm] of the program is above 0 and below least_tolerance,
/// which then replaces it.
bool is_too_small(double tolerance);
/// Message about such a tolerance; `words`: "tolerance P0.0000001 of G64".
DiagnosticLog::Text too_small_text(const Message& words);

/// The first with a contour tolerance or a blend distance; nullptr for none.
const PathControl* find_own_tolerance(std::span<const PathControl> controls);

/// "fine", "coarse", "interpolation end"; empty for the machine's.
std::string_view to_string(ExactStopWindow window);

/// "continuous, contour tolerance 0.01 mm, compaction on"; "as the machine" for an empty one.
Message describe(const PathControl& control);

}  // namespace feedscope
