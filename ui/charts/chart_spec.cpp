#include "ui/charts/chart_spec.h"

#include <QCoreApplication>

#include "core/base/geometry.h"
#include "core/base/units.h"

namespace feedscope::ui {

namespace {

constexpr double path_width = 1.8;
constexpr double axis_width = 1.1;
constexpr std::array axis_roles{CurveRole::x, CurveRole::y, CurveRole::z};

QString tr(const char* text) {
  return QCoreApplication::translate("KinematicCharts", text);
}

/// `first` and the two channels after it are those of X, Y and Z; keys are `letter` with the axis.
void add_axes(ChartSpec& spec, Channel first, char letter) {
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    const QChar axis(axis_names[i]);
    spec.curves.push_back({static_cast<Channel>(static_cast<std::size_t>(first) + i),
                           QString(QChar(letter)) + axis.toLower(), QString(axis), axis_roles[i],
                           axis_width});
  }
}

}  // namespace

QColor curve_colour(CurveRole role, const ThemeColours& colours) {
  switch (role) {
    case CurveRole::path:
      return colours.path;
    case CurveRole::programmed:
      return colours.programmed;
    case CurveRole::x:
    case CurveRole::y:
    case CurveRole::z:
      return colours.axes[static_cast<std::size_t>(role) - static_cast<std::size_t>(CurveRole::x)];
  }
  return colours.path;
}

std::array<ChartSpec, chart_count> kinematic_chart_specs() {
  const QString tangential = tr("tangential");
  ChartSpec feed{tr("Feed"),
                 tr("mm/min"),
                 {{Channel::feed, "feed", tr("achieved"), CurveRole::path, path_width},
                  {Channel::programmed_feed, "programmed_feed", tr("programmed"), CurveRole::programmed,
                   path_width, true}},
                 units::to_mm_min,
                 0};
  add_axes(feed, Channel::velocity_x, 'v');
  ChartSpec acceleration{tr("Acceleration"),
                         tr("m/s²"),
                         {{Channel::tangential_acceleration, "at", tangential, CurveRole::path, path_width}},
                         units::to_m,
                         2};
  add_axes(acceleration, Channel::acceleration_x, 'a');
  ChartSpec jerk{tr("Jerk"),
                 tr("m/s³"),
                 {{Channel::tangential_jerk, "jt", tangential, CurveRole::path, path_width, true}},
                 units::to_m,
                 1};
  add_axes(jerk, Channel::jerk_x, 'j');
  return {feed, acceleration, jerk};
}

}  // namespace feedscope::ui
