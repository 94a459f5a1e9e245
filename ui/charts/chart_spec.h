#pragma once

#include <QColor>
#include <QString>
#include <array>
#include <cstdint>
#include <vector>

#include "ui/charts/envelope.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

/// What a curve shows, which gives it its colour in every theme.
enum class CurveRole : std::uint8_t { path, programmed, x, y, z };
QColor curve_colour(CurveRole role, const ThemeColours& colours);

struct CurveSpec {
  Channel channel;
  QString key;  ///< stable, for files: "feed", "vx"
  QString name;
  CurveRole role = CurveRole::path;
  double width = 1;         ///< [px]
  bool may_be_cut = false;  ///< the chart need not grow far beyond the other curves to show it in full
};

struct ChartSpec {
  QString title;
  QString unit;
  std::vector<CurveSpec> curves;        ///< as the header lists them
  double (*convert)(double) = nullptr;  ///< from the core's unit to `unit`
  int decimals = 0;                     ///< of values shown as numbers
};

inline constexpr std::size_t chart_count = 3;

/// Feed, acceleration and jerk of a run.
std::array<ChartSpec, chart_count> kinematic_chart_specs();

}  // namespace feedscope::ui
