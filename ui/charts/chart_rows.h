#pragma once

#include <QPainter>
#include <QVBoxLayout>
#include <array>

#include "ui/charts/chart_columns.h"
#include "ui/charts/chart_header.h"
#include "ui/charts/charts_state.h"
#include "ui/charts/feed_shares.h"
#include "ui/charts/kinematic_chart.h"
#include "ui/charts/lost_time_chart.h"
#include "ui/charts/overlay_curves.h"
#include "ui/charts/usual_curves.h"

namespace feedscope::ui {

/// The charts of a panel, one above the other, each below its header.
struct ChartRows {
  static constexpr int stretch = 3;  ///< of a chart in the layout

  std::array<ChartHeader*, chart_count> headers{};
  std::array<KinematicChart*, chart_count> charts{};
  std::array<bool, chart_count> hidden{};  ///< by the user, or until the user requests them
  LostTimeChart* lost = nullptr;           ///< below the first chart
  FeedShares* shares = nullptr;            ///< to the right of the first chart

  /// Whether a run with this envelope (null: any run) has this chart.
  bool has(const Envelope* envelope, std::size_t chart) const;

  /// Shows the charts with values in `envelope` (null: those of every run) that are not hidden; the last one
  /// has the abscissa, with this title.
  void show(const Envelope* envelope, const QString& abscissa, QVBoxLayout& layout) const;
  void show_columns(const ChartColumns& columns, const OverlayCurves& overlays) const;
  /// Shows the usual range of the curves, and the time at each feed.
  void show_usual(const UsualMotion& usual) const;
  /// Shows the time at each feed to the right of the charts if they need less than `width`; else hides it.
  /// `layout`: of the charts.
  void give_shares_room(QLayout& layout, int width) const;
  /// Shows at each chart the values that its plot omits or adds.
  void show_notes() const;
  /// Moves the time at each feed to the first chart.
  void place_shares() const;
  /// Shows values at `state` in the headers; null: no values. `sources`: of its run.
  void show_values(const State* state, const RunSources& sources) const;
  /// Ordinates chosen by the user, in their unit.
  std::array<std::optional<Interval>, chart_count> chosen_values() const;
  void choose_values(const std::array<std::optional<Interval>, chart_count>& values) const;
  /// Adds the hidden curves and the chosen values, to be saved.
  void add_to(ChartsState& state) const;
  /// Room for the shown parts of `content`, for at most three charts.
  QSize least_size(const QWidget& content) const;
  /// Draws headers and charts at their places in `content`.
  void draw(QPainter& painter, const QWidget& content) const;
  /// Limits of velocity, acceleration and jerk.
  void set_limits(const AxisVector<AxisLimits>& limits, bool of_jerk) const;
  /// Limits of velocity, acceleration and jerk of rotary axes.
  void set_rotary_limits(const MachineKinematics& kinematics) const;
  /// Lists the curves that a run has.
  void set_sources(const RunSources& sources) const;
  /// Sets the bounds of the operations; null: none.
  void set_bounds(const RunLoad* load) const;
};

/// Calls `paint` with the painter moved to the place of `part` in `content`, if it is shown.
template <typename Paint>
void draw_part(QPainter& painter, const QWidget& content, const QWidget& part, Paint paint) {
  if (part.isVisibleTo(&content)) {
    painter.save();
    painter.translate(part.mapTo(&content, QPoint()));
    painter.setClipRect(part.rect());
    paint();
    painter.restore();
  }
}

}  // namespace feedscope::ui
