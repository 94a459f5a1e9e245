#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/contour/contour_errors.h"
#include "core/analysis/run.h"

namespace feedscope {

/// What the programmed path is where the executed one leaves it.
struct ContourSpot {
  enum class Kind : std::uint8_t { line, arc, corner };

  Kind kind = Kind::line;
  double length = 0;          ///< of the block [mm]
  double radius = 0;          ///< of an arc [mm]
  double turn = 0;            ///< of a corner: change of direction [rad]
  std::size_t neighbour = 0;  ///< of a corner: the block that meets that of the place in it
  bool inside = false;        ///< the executed path lies on the inner side of the corner or arc
};

/// The corner that lies no farther from the place than one cut there would, or the block.
ContourSpot contour_spot(const Toolpath& programmed, const ContourPlace& place);

/// One of the worst places of a run with what people ask of it.
struct ContourFinding {
  ContourPlace place;
  ContourSpot spot;
  std::string block;                ///< as block_number(); empty without one
  double feed = 0;                  ///< achieved [mm/s]
  double programmed_feed = 0;       ///< [mm/s]; for a rapid the axes' speed along it
  Cause cause;                      ///< of the feed
  std::optional<double> tolerance;  ///< contour tolerance that rules there [mm]
};

/// Contour error of the feed motions of a run for people: how much, how often, where, and against which
/// tolerance.
struct ContourReport {
  double largest = 0;                 ///< [mm]
  std::optional<double> rapids;       ///< the largest of the rapids, where it is above `largest` [mm]
  std::vector<ContourFinding> worst;  ///< the largest first; within 10 nm in the order of the program
  ContourSpread spread;
  /// The deviation lies in XY, that of the worst place too, so that left and right of the path say it.
  bool is_flat() const;
  /// Least and largest contour tolerance of the feed motions; none where the model reads none or follows
  /// the path exactly [mm].
  std::optional<std::array<double, 2>> tolerance;
  bool own_tolerances = false;  ///< as Guarantees: the control rounds corners within a tolerance of its own
  bool program_tolerances = true;  ///< those of the program go before it
};

/// `places`: how many of the worst, at least 1. Throws Cancelled.
ContourReport contour_report(const Run& run, std::size_t places, Progress* progress = nullptr);

/// Whether an error is within a tolerance [mm], but for what is no more than the end of a search: 1e-4 of the
/// tolerance.
bool keeps_tolerance(double error, double tolerance);

}  // namespace feedscope
