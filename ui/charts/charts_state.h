#pragma once

#include <QJsonObject>
#include <QStringList>
#include <array>
#include <optional>

#include "ui/charts/chart_spec.h"
#include "ui/charts/value_fit.h"
#include "ui/shared/view_range.h"

namespace feedscope::ui {

/// The user's settings of the charts, restored by sessions and the next start. Curves by CurveSpec::key.
struct ChartsState {
  Abscissa abscissa = Abscissa::time;
  std::optional<Interval> time = {};  ///< shown [s]; none: the whole run
  std::array<std::optional<Interval>, chart_count> values =
      {};                                    ///< ordinates chosen by the user, in their unit
  QStringList hidden = {};                   ///< curves, in the order of the charts
  QStringList shown = {};                    ///< curves that are hidden until the user requests them
  QStringList hidden_charts = {};            ///< by ChartSpec::key
  QStringList shown_charts = {};             ///< charts that are hidden until the user requests them
  QStringList other_runs = {};               ///< curves shown for other runs, at most one in a chart
  bool causes = true;                        ///< whether the strip of limiting causes is shown
  std::optional<double> second_cursor = {};  ///< [s]

  bool operator==(const ChartsState&) const = default;
};

/// `state` without the parts that belong to one run: range, ordinates, second cursor.
ChartsState for_any_run(ChartsState state);

bool is_shown(const CurveSpec& curve, const ChartsState& state);
bool is_shown(const ChartSpec& chart, const ChartsState& state);

QJsonObject to_json(const ChartsState& state);
/// Missing or wrong values leave `state` unchanged.
void read_json(const QJsonObject& json, ChartsState& state);

}  // namespace feedscope::ui
