#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/contour/contour_errors.h"
#include "core/analysis/run/run.h"

namespace feedscope {

/// Feature of the programmed path that the executed path leaves.
struct ContourSpot {
  enum class Kind : std::uint8_t { line, arc, corner };

  Kind kind = Kind::line;
  double length = 0;          ///< of the block [mm]
  double radius = 0;          ///< of an arc [mm]
  double turn = 0;            ///< of a corner: change of direction [rad]
  std::size_t neighbour = 0;  ///< of a corner: the block that meets the place's block there
  bool inside = false;        ///< the executed path is on the inner side of the corner or arc
};

/// The corner, if `place` is at most twice as far from it as on an evenly cut corner; else the block.
ContourSpot contour_spot(const Toolpath& programmed, const ContourPlace& place);

/// One of the worst places of a run, with the data shown for it.
struct ContourFinding {
  ContourPlace place;
  ContourSpot spot;
  std::string block;                ///< as block_number(); empty without one
  double feed = 0;                  ///< achieved [mm/s]
  double programmed_feed = 0;       ///< [mm/s]; for a rapid the axes' speed along it
  Cause cause;                      ///< limiting cause of the feed
  std::optional<double> tolerance;  ///< contour tolerance in force there [mm]
};

/// Contour error of the feed motions of a run for display: amount, distribution, places and tolerance.
struct ContourReport {
  double largest = 0;                 ///< [mm]
  std::optional<double> rapids;       ///< largest error of the rapids, if above `largest` [mm]
  std::vector<ContourFinding> worst;  ///< largest first; within 10 nm in order of the program
  ContourSpread spread;
  /// Whether the deviation is in XY, including that of the worst place, so that left and right of the path
  /// describe it.
  bool is_flat() const;
  /// Smallest and largest contour tolerance of the feed motions [mm]; none if the model reads none or follows
  /// the path exactly.
  std::optional<std::array<double, 2>> tolerance;
  bool own_tolerances = false;     ///< as Guarantees: corners are rounded within the control's own tolerance
  bool program_tolerances = true;  ///< tolerances of the program take precedence
};

/// `places`: number of worst places, at least 1. Throws Cancelled.
ContourReport contour_report(const Run& run, std::size_t places, Progress* progress = nullptr);

/// Whether an error is within a tolerance [mm], up to the precision of a search: 1e-4 of the tolerance.
bool keeps_tolerance(double error, double tolerance);

}  // namespace feedscope
