#include "ui/scene_view/scene_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <cmath>

#include "core/base/units.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/scene/cause_colour.h"

namespace feedscope::ui {

namespace {

struct Scene {
  Q_DECLARE_TR_FUNCTIONS(Scene)
};

/// Without group separators: VTK's font lacks the narrow space that French uses.
QString number(double value, int decimals) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(value, 'f', decimals);
}

QString number(double value, Dimension dimension, int metric_decimals = -1) {
  return number(in_shown_unit(value, dimension), decimals_of(dimension, metric_decimals));
}

QString amount(double value, Dimension dimension, int metric_decimals = -1) {
  return QStringLiteral("%1 %2").arg(number(value, dimension, metric_decimals), unit_of(dimension));
}

}  // namespace

SceneTexts scene_texts() {
  SceneTexts texts;
  texts.programmed = Scene::tr("programmed").toStdString();
  texts.rapid = Scene::tr("rapid").toStdString();
  texts.executed = Scene::tr("executed").toStdString();
  texts.actual = Scene::tr("actual path").toStdString();
  texts.blend = Scene::tr("corner blend").toStdString();
  texts.curve = Scene::tr("smooth curve").toStdString();
  texts.tool_axis = Scene::tr("tool axis").toStdString();
  texts.start = Scene::tr("start", "of the path").toStdString();
  texts.on_machine = Scene::tr("X, Y and Z of the machine").toStdString();
  texts.assumed = Scene::tr("assumed", "zero point of a work offset").toStdString();
  texts.beneath = Scene::tr("%1 (beneath the path)").toStdString();
  texts.exaggerated = Scene::tr("deviation drawn × %1").toStdString();
  texts.contour_error = Scene::tr("Contour error").toStdString();
  texts.time_lost = Scene::tr("Time lost or gained").toStdString();
  texts.path_distance = Scene::tr("Distance to the other run").toStdString();
  texts.time_lost_against = Scene::tr("Time lost or gained against %1").toStdString();
  texts.path_distance_from = Scene::tr("Distance from %1").toStdString();
  texts.lost = Scene::tr("lost").toStdString();
  texts.won = Scene::tr("gained").toStdString();
  texts.cause = Scene::tr("Limiting cause").toStdString();
  texts.quantity = [](const QuantityInfo& info) { return core_text(std::string(info.title)).toStdString(); };
  texts.cause_kind = [](CauseKind kind) { return shown_cause({kind, -1}).toStdString(); };
  texts.decimal_point = QLocale().decimalPoint().toStdString();
  return texts;
}

QString hover_text(const State& state, double contour_error) {
  const QString cause = shown_cause(state.cause);
  QStringList lines{
      Scene::tr("Line %1").arg(state.line),
      Scene::tr("Feed %1 of %2")
          .arg(number(state.speed, Dimension::feed), amount(state.programmed_feed, Dimension::feed)),
      Scene::tr("Limited by: %1").arg(cause),
      Scene::tr("Contour error %1").arg(amount(contour_error, Dimension::error))};
  return lines.join('\n');
}

QString drives_text(const ActualSample& actual) {
  const Vec3& error = actual.motion.following_error;
  return QStringList{
      Scene::tr("Contour error of the actual path %1").arg(amount(actual.contour_error, Dimension::error)),
      Scene::tr("Following error X %1, Y %2, Z %3")
          .arg(number(error.x(), Dimension::error), number(error.y(), Dimension::error),
               amount(error.z(), Dimension::error))}
      .join('\n');
}

QString load_text(const LoadSample& load) {
  if (!load.has_load()) {
    return {};
  }
  return QStringList{Scene::tr("Chip thickness %1 (%2 at the programmed feed)")
                         .arg(amount(load.predicted.chip_thickness, Dimension::error),
                              amount(load.programmed.chip_thickness, Dimension::error)),
                     Scene::tr("Peak cutting force %1 (%2 at the programmed feed)")
                         .arg(amount(load.predicted.peak_force, Dimension::force),
                              amount(load.programmed.peak_force, Dimension::force))}
      .join('\n');
}

QString comparison_text(const PlaceComparison& place) {
  const auto lost_or_won = [](double value, const QString& lost, const QString& won, Dimension dimension) {
    return (value < 0 ? won : lost).arg(amount(std::abs(value), dimension));
  };
  return QStringList{
      Scene::tr("Compared with %1:").arg(place.reference),
      lost_or_won(place.pace, Scene::tr("lost here: %1"), Scene::tr("gained here: %1"), Dimension::pace),
      Scene::tr("feed %1, other run %2")
          .arg(number(place.feed, Dimension::feed), amount(place.reference_feed, Dimension::feed)),
      lost_or_won(place.lost, Scene::tr("lost since the start: %1"), Scene::tr("gained since the start: %1"),
                  Dimension::time),
      Scene::tr("reached after %1 s, by the other run after %2 s")
          .arg(number(place.time, 3), number(place.time - place.lost, 3)),
      Scene::tr("paths %1 apart").arg(amount(place.distance, Dimension::error))}
      .join('\n');
}

std::vector<std::string> measurement_lines(const State& from, const State& to) {
  const Vec3 delta = to.position - from.position;
  const QStringList lines{
      Scene::tr("Distance %1").arg(amount(delta.norm(), Dimension::length, 4)),
      Scene::tr("dX %1   dY %2   dZ %3")
          .arg(number(delta.x(), Dimension::length), number(delta.y(), Dimension::length),
               amount(delta.z(), Dimension::length)),
      Scene::tr("Path length %1").arg(amount(std::abs(to.path_length - from.path_length), Dimension::length)),
      Scene::tr("Time %1 s").arg(number(std::abs(to.time - from.time), 4))};
  std::vector<std::string> texts;
  for (const QString& line : lines) {
    texts.push_back(line.toStdString());
  }
  return texts;
}

}  // namespace feedscope::ui
