#pragma once

#include <optional>
#include <string>

#include "core/base/units.h"
#include "core/program/heidenhain/geometry/contour_writer.h"
#include "core/program/heidenhain/language/motion_words.h"

namespace feedscope::heidenhain {

/// Modal state shared by several parts of the readers.
struct ModalState {
  double unit = 1;  ///< mm per written length
  ContourFeed feed;
  double tool_feed = 0;  ///< of the last tool call, as written
  FeedWord tool_feed_word = FeedWord::value;
  double spindle_speed = 0;  ///< [1/min]; 0: none yet
  std::string tool;          ///< number or name of the called one
  std::optional<double> tool_radius;
  int side = 0;  ///< of the tool: 1 left of the contour, -1 right, 0 on it
  std::optional<Vec3> pole;
  Plane pole_plane = Plane::xy;

  /// Q120 to Q122 were read: the control's calculated angles for the tilted plane.
  bool calculated_angles = false;
  bool tool_centre_point = false;  ///< M128: X, Y and Z are those of the tip
  bool shortest_way = false;       ///< M126: rotary axes go the shortest way
  bool great_circle = false;       ///< PATHCTRL VECTOR: the tool goes along great circles

  bool is_inch() const { return unit != 1; }
  double to_mm(double value) const { return value * unit; }
  /// A feed as written, in mm/s. In inch programs the control counts feeds in tenths of an inch a minute
  /// (TNC 640 Klartext programming, F).
  double to_feed(double value) const {
    return units::from_mm_min(is_inch() ? units::from_inch(value / 10) : value);
  }
};

}  // namespace feedscope::heidenhain
