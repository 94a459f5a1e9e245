#include "ui/charts/chart_spec.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include "core/base/geometry.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"

namespace feedscope::ui {

namespace {

constexpr double path_width = 1.8;
constexpr double axis_width = 1.1;
constexpr std::array axis_roles{CurveRole::x, CurveRole::y, CurveRole::z};
constexpr std::array machine_roles{CurveRole::machine_x, CurveRole::machine_y, CurveRole::machine_z};

struct KinematicCharts {
  Q_DECLARE_TR_FUNCTIONS(KinematicCharts)
};

QString text_of(std::string_view text) {
  return core_text(std::string(text));
}

/// "vx" of "vx_mm_min".
QString key_of(const QuantityInfo& quantity) {
  static const QRegularExpression unit(QStringLiteral("_((mm|m|rev)_(min|s2|s3)|deg)$"));
  QString key = QString::fromStdString(std::string(quantity.column));
  return key.remove(unit);
}

/// Whether a quantity is of the machine's X, Y or Z, as opposed to the tip.
bool is_of_machine(const QuantityInfo& quantity) {
  return quantity.id >= QuantityId::machine_velocity_x && quantity.id <= QuantityId::machine_z;
}

CurveRole role_of(const QuantityInfo& quantity) {
  if (quantity.axis >= 0) {  // A, B and C like the axes that they turn about
    const auto axis = static_cast<std::size_t>(quantity.axis) % axis_roles.size();
    return is_of_machine(quantity) ? machine_roles[axis] : axis_roles[axis];
  }
  switch (quantity.id) {
    case QuantityId::programmed_feed:
    case QuantityId::peak_force_programmed:
    case QuantityId::chip_thickness_programmed:
      return CurveRole::programmed;
    case QuantityId::acceleration_across:
    case QuantityId::following_error_across:
    case QuantityId::mean_force:
      return CurveRole::across;
    default:
      return CurveRole::path;
  }
}

CurveSpec curve_of(const QuantityInfo& quantity) {
  const bool of_axis = quantity.axis >= 0;
  QString name = text_of(quantity.curve);
  if (of_axis) {
    const QChar axis(cause_axes[static_cast<std::size_t>(quantity.axis)].name);
    name = quantity.curve.empty() ? QString(axis) : name.arg(axis);
  }
  CurveSpec curve{quantity.id, key_of(quantity), name, role_of(quantity), of_axis ? axis_width : path_width};
  curve.may_be_cut = quantity.id == QuantityId::programmed_feed || quantity.id == QuantityId::tangential_jerk;
  curve.on_demand = quantity.id == QuantityId::acceleration_across || is_of_machine(quantity) ||
                    (of_axis && quantity.chart == QuantityChart::feed);
  return curve;
}

/// Curves of the path first, then of the axes.
ChartSpec chart_of(QuantityChart chart, const char* key, const QString& title) {
  ChartSpec spec;
  spec.key = QLatin1String(key);
  spec.title = title;
  for (const bool of_axis : {false, true}) {
    for (const QuantityInfo& quantity : all_quantities()) {
      if (quantity.chart == chart && (quantity.axis >= 0) == of_axis) {
        const ShownUnit& unit = shown(quantity.dimension);
        if (spec.curves.empty()) {
          spec.source = quantity.source;
        }
        spec.unit = unit_of(quantity.dimension);
        spec.factor = unit.factor;
        spec.decimals = unit.decimals;
        spec.curves.push_back(curve_of(quantity));
      }
    }
  }
  return spec;
}

}  // namespace

namespace {

QColor half_way(const QColor& a, const QColor& b) {
  return QColor::fromRgbF((a.redF() + b.redF()) / 2, (a.greenF() + b.greenF()) / 2,
                          (a.blueF() + b.blueF()) / 2);
}

}  // namespace

QColor curve_colour(CurveRole role, const ThemeColours& colours) {
  switch (role) {
    case CurveRole::path:
      return colours.path;
    case CurveRole::programmed:
      return colours.programmed;
    case CurveRole::across:
      return colours.across;
    case CurveRole::x:
    case CurveRole::y:
    case CurveRole::z:
      return colours.axes[static_cast<std::size_t>(role) - static_cast<std::size_t>(CurveRole::x)];
    case CurveRole::machine_x:
    case CurveRole::machine_y:
    case CurveRole::machine_z:
      return half_way(
          colours.axes[static_cast<std::size_t>(role) - static_cast<std::size_t>(CurveRole::machine_x)],
          colours.text);
  }
  return colours.path;
}

std::array<ChartSpec, chart_count> kinematic_chart_specs() {
  std::array<ChartSpec, chart_count> specs{
      chart_of(QuantityChart::feed, "feed", KinematicCharts::tr("Feed")),
      chart_of(QuantityChart::acceleration, "acceleration", KinematicCharts::tr("Acceleration")),
      chart_of(QuantityChart::jerk, "jerk", KinematicCharts::tr("Jerk")),
      chart_of(QuantityChart::following_error, "following_error", KinematicCharts::tr("Following error")),
      chart_of(QuantityChart::force, "cutting_force", KinematicCharts::tr("Cutting force")),
      chart_of(QuantityChart::chip, "chip_thickness", KinematicCharts::tr("Chip thickness")),
      chart_of(QuantityChart::rotary_position, "rotary_position",
               KinematicCharts::tr("Position of rotary axes")),
      chart_of(QuantityChart::rotary_velocity, "rotary_velocity",
               KinematicCharts::tr("Velocity of rotary axes")),
      chart_of(QuantityChart::rotary_acceleration, "rotary_acceleration",
               KinematicCharts::tr("Acceleration of rotary axes")),
      chart_of(QuantityChart::rotary_jerk, "rotary_jerk", KinematicCharts::tr("Jerk of rotary axes"))};
  for (const std::size_t chart : {rotary_acceleration_chart, rotary_jerk_chart}) {
    specs[chart].on_demand = true;  // six charts are enough at first
  }
  return specs;
}

}  // namespace feedscope::ui
