#pragma once

#include <QJsonObject>
#include <vector>

#include "core/analysis/circularity/circle_plane.h"

namespace feedscope::ui {

/// The user's settings of the circular test, restored by sessions and the next start.
struct CircularState {
  bool of_program = false;             ///< whether it shows the circles of the program, not a test
  std::vector<double> radii = {30};    ///< [mm]
  std::vector<double> feeds = {6000};  ///< [mm/min]
  CirclePlane plane = CirclePlane::xy;
  bool entry_arc = false;
  double entry_radius = 10;  ///< [mm]

  bool operator==(const CircularState&) const = default;
};

/// Maximum number of tests in one table.
inline constexpr std::size_t max_circular_tests = 100;

QJsonObject to_json(const CircularState& state);
/// Missing or wrong values leave `state` unchanged.
void read_json(const QJsonObject& json, CircularState& state);

}  // namespace feedscope::ui
