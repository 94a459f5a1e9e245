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
  std::array<bool, chart_count> hidden{};  ///< by the user, or until the user asks for them
  LostTimeChart* lost = nullptr;           ///< below the first chart
  FeedShares* shares = nullptr;            ///< beside the first chart

  /// Whether a run with this envelope (null: any run) has this chart.
  bool has(const Envelope* envelope, std::size_t chart) const;

  /// Shows those that `envelope` has values for (null: the ones of every run) and that nobody has hidden; the
  /// last of them carries the abscissa, with this title.
  void show(const Envelope* envelope, const QString& abscissa, QVBoxLayout& layout) const;
  void show_columns(const ChartColumns& columns, const OverlayCurves& overlays) const;
  /// Where the curves usually are, and the time at each feed.
  void show_usual(const UsualMotion& usual) const;
  /// Gives the time at each feed its room beside the charts where they need less than `width`; else it is
  /// not shown. `layout`: of the charts.
  void give_shares_room(QLayout& layout, int width) const;
  /// Beside each chart what its plot leaves out or adds.
  void show_notes() const;
  /// Beside the first chart, when that has moved.
  void place_shares() const;
  /// In the headers, at `state`; null: no values. `sources`: of its run.
  void show_values(const State* state, const RunSources& sources) const;
  /// Ordinates that the user chose, in their unit.
  std::array<std::optional<Interval>, chart_count> chosen_values() const;
  void choose_values(const std::array<std::optional<Interval>, chart_count>& values) const;
  /// What is hidden and chosen, to keep.
  void add_to(ChartsState& state) const;
  /// Room for what is shown in `content`, for three charts where there are more.
  QSize least_size(const QWidget& content) const;
  /// Headers and charts, as they stand in `content`.
  void draw(QPainter& painter, const QWidget& content) const;
  /// Of velocity, acceleration and jerk.
  void set_limits(const AxisVector<AxisLimits>& limits) const;
  /// Of velocity, acceleration and jerk of rotary axes.
  void set_rotary_limits(const MachineKinematics& kinematics) const;
  /// Lists the curves of what a run has.
  void set_sources(const RunSources& sources) const;
  /// Bounds of the operations; null: none.
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
