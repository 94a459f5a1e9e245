#pragma once

#include <QJsonObject>
#include <QStringList>
#include <array>
#include <optional>

#include "ui/charts/chart_spec.h"
#include "ui/charts/value_fit.h"
#include "ui/shared/view_range.h"

namespace feedscope::ui {

/// What a user has set in the charts, as sessions and the next start get it back. Curves by CurveSpec::key.
struct ChartsState {
  Abscissa abscissa = Abscissa::time;
  std::optional<Interval> time = {};  ///< shown [s]; none: the whole run
  std::array<std::optional<Interval>, chart_count> values =
      {};                          ///< ordinates that the user chose, in their unit
  QStringList hidden = {};         ///< curves, in the order of the charts
  QStringList shown = {};          ///< curves that are hidden until the user asks for them
  QStringList hidden_charts = {};  ///< by ChartSpec::key
  QStringList shown_charts = {};   ///< of those that are hidden until the user asks for them
  QStringList other_runs = {};     ///< curves that the charts show of other runs, at most one a chart
  bool causes = true;              ///< the strip of limiting causes is shown
  std::optional<double> second_cursor = {};  ///< [s]

  bool operator==(const ChartsState&) const = default;
};

/// The same without what belongs to one run: range, ordinates, second cursor.
ChartsState for_any_run(ChartsState state);

bool is_shown(const CurveSpec& curve, const ChartsState& state);
bool is_shown(const ChartSpec& chart, const ChartsState& state);

QJsonObject to_json(const ChartsState& state);
/// What is missing or wrong stays as it is in `state`.
void read_json(const QJsonObject& json, ChartsState& state);

}  // namespace feedscope::ui
