#pragma once

#include <QJsonObject>
#include <vector>

#include "core/analysis/circularity/circle_plane.h"

namespace feedscope::ui {

/// What a user has set in the circular test, as sessions and the next start get it back.
struct CircularState {
  bool of_program = false;             ///< the circles of the program, not a test
  std::vector<double> radii = {30};    ///< [mm]
  std::vector<double> feeds = {6000};  ///< [mm/min]
  CirclePlane plane = CirclePlane::xy;
  bool entry_arc = false;
  double entry_radius = 10;  ///< [mm]

  bool operator==(const CircularState&) const = default;
};

/// Tests of one table at most.
inline constexpr std::size_t max_circular_tests = 100;

QJsonObject to_json(const CircularState& state);
/// What is missing or wrong stays as it is in `state`.
void read_json(const QJsonObject& json, CircularState& state);

}  // namespace feedscope::ui
