#pragma once

#include <array>
#include <functional>
#include <string>

#include "core/analysis/run/quantity.h"
#include "core/limits/cause.h"
#include "ui/scene/colour_map.h"

namespace feedscope::ui {

/// Colours of everything except path values. Lines and text contrast with the background, and differ without
/// red and green.
struct SceneColours {
  Background kind = Background::light;
  Rgb background;
  Rgb text;
  Rgb frame;
  Rgb grid;
  Rgb programmed;
  Rgb rapid;
  Rgb actual;  ///< the actual path
  Rgb blend_edge;
  Rgb curve_edge;
  Rgb tool;
  Rgb highlight;  ///< range of the charts, measurement
  std::array<Rgb, 3> axes;
};

const SceneColours& scene_colours(Background kind);

/// All texts that the scene draws; the caller may translate them. UTF-8, Latin letters.
struct SceneTexts {
  std::string programmed = "programmed";
  std::string rapid = "rapid";
  std::string executed = "executed";
  std::string actual = "actual path";  ///< actual path of the axes
  std::string blend = "corner blend";
  std::string curve = "smooth curve";
  std::string tool_axis = "tool axis";
  std::string start = "start";                    ///< of the path
  std::string beneath = "%1 (beneath the path)";  ///< %1: a run that the coloured one hides
  std::string on_machine = "X, Y and Z of the machine";
  std::string assumed = "assumed";                   ///< of a zero point
  std::string exaggerated = "deviation drawn × %1";  ///< %1: the factor
  std::string contour_error = "Contour error";
  std::string time_lost = "Time lost or gained";
  std::string path_distance = "Distance to the other run";
  std::string time_lost_against = "Time lost or gained against %1";  ///< %1: the other run
  std::string path_distance_from = "Distance from %1";               ///< %1: the other run
  std::string lost = "lost";
  std::string won = "gained";
  std::string cause = "Limiting cause";
  std::function<std::string(CauseKind)> cause_kind;          ///< null: cause_title
  std::function<std::string(const QuantityInfo&)> quantity;  ///< null: its English title
  std::string decimal_point = ".";

  std::string name_of(CauseKind kind) const;
  std::string name_of(const QuantityInfo& info) const;
  /// A number of a tick label with this decimal point and a true minus sign.
  std::string localised(std::string number) const;
};

}  // namespace feedscope::ui
