#pragma once

#include <vector>

#include "core/analysis/contour/contour_errors.h"
#include "core/analysis/contour/contour_search.h"

namespace feedscope {

/// Component of the offset of a place in XY across the programmed direction, positive to the left [mm].
double side_of(const Trajectory& trajectory, const ContourNode& node);

/// Divides a run where its distance from the programmed path has at least halved and doubled again, and keeps
/// the worst places of these stretches.
class WorstPlaces {
 public:
  WorstPlaces(ContourSearch& search, std::size_t most) : search_(search), most_(most) {}

  /// Processes the next span in order.
  void visit(const ContourSpan& span);
  /// Whether a place with this error would be kept.
  bool takes(double error) const;
  /// Adds the worst place of a stretch in which no place is farther than `bound` [mm].
  void add(const ContourNode& place, double bound);
  /// Writes the results to `errors`.
  void finish(ContourErrors& errors, const Trajectory& trajectory);

 private:
  void close();
  void prune();

  ContourSearch& search_;
  std::size_t most_;
  std::vector<ContourNode> worst_;  ///< heap, smallest first
  double highest_ = 0;              ///< no place of the run is farther from the path [mm]
  bool open_ = false;
  std::uint32_t last_element_ = 0;
  ContourNode best_;                  ///< of the current stretch
  double low_ = 0;                    ///< smallest error since then [mm]
  std::vector<ContourSpan> hopeful_;  ///< spans of the stretch that may contain a farther place
};

}  // namespace feedscope
