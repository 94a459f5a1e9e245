#include "ui/views/scene_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <cmath>

#include "core/base/units.h"
#include "ui/language/core_texts.h"
#include "ui/scene/cause_colour.h"

namespace feedscope::ui {

namespace {

struct Scene {
  Q_DECLARE_TR_FUNCTIONS(Scene)
};

/// Without group separators: VTK's font has no narrow space, which French puts there.
QString number(double value, int decimals) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(value, 'f', decimals);
}

}  // namespace

SceneTexts scene_texts() {
  SceneTexts texts;
  texts.programmed = Scene::tr("programmed").toStdString();
  texts.rapid = Scene::tr("rapid").toStdString();
  texts.executed = Scene::tr("executed").toStdString();
  texts.blend = Scene::tr("corner blend").toStdString();
  texts.assumed = Scene::tr("assumed", "zero point of a work offset").toStdString();
  texts.exaggerated = Scene::tr("deviation drawn × %1").toStdString();
  texts.feed = Scene::tr("Feed").toStdString();
  texts.feed_ratio = Scene::tr("Feed / programmed").toStdString();
  texts.tangential_acceleration = Scene::tr("Tangential acceleration").toStdString();
  texts.acceleration = Scene::tr("Acceleration").toStdString();
  texts.tangential_jerk = Scene::tr("Tangential jerk").toStdString();
  texts.jerk = Scene::tr("Jerk").toStdString();
  texts.contour_error = Scene::tr("Contour error").toStdString();
  texts.time_lost = Scene::tr("Time lost or won").toStdString();
  texts.path_distance = Scene::tr("Distance to the other run").toStdString();
  texts.time_lost_against = Scene::tr("Time lost or won against %1").toStdString();
  texts.path_distance_from = Scene::tr("Distance from %1").toStdString();
  texts.lost = Scene::tr("lost").toStdString();
  texts.won = Scene::tr("won").toStdString();
  texts.cause = Scene::tr("Limiting cause").toStdString();
  texts.views = {Scene::tr("iso").toStdString(),    Scene::tr("top").toStdString(),
                 Scene::tr("front").toStdString(),  Scene::tr("right").toStdString(),
                 Scene::tr("bottom").toStdString(), Scene::tr("back").toStdString(),
                 Scene::tr("left").toStdString()};
  texts.cause_kind = [](CauseKind kind) { return core_text(cause_kind_title(kind)).toStdString(); };
  texts.decimal_point = QLocale().decimalPoint().toStdString();
  return texts;
}

QString hover_text(const State& state, double contour_error) {
  const QString cause = core_text(cause_title(state.cause));
  QStringList lines{
      Scene::tr("Line %1").arg(state.line),
      Scene::tr("Feed %1 of %2 mm/min")
          .arg(number(units::to_mm_min(state.speed), 0), number(units::to_mm_min(state.programmed_feed), 0)),
      Scene::tr("Limited by: %1").arg(cause),
      Scene::tr("Contour error %1 µm").arg(number(1000 * contour_error, 1))};
  return lines.join('\n');
}

QString comparison_text(const PlaceComparison& place) {
  const auto lost_or_won = [](double value, const QString& lost, const QString& won, double factor,
                              int decimals) {
    return (value < 0 ? won : lost).arg(number(std::abs(value) * factor, decimals));
  };
  return QStringList{
      Scene::tr("Against %1:").arg(place.reference),
      lost_or_won(place.pace, Scene::tr("lost here: %1 ms/mm"), Scene::tr("won here: %1 ms/mm"), 1000, 3),
      Scene::tr("feed %1, there %2 mm/min")
          .arg(number(units::to_mm_min(place.feed), 0), number(units::to_mm_min(place.reference_feed), 0)),
      lost_or_won(place.lost, Scene::tr("lost since the start: %1 s"), Scene::tr("won since the start: %1 s"),
                  1, 3),
      Scene::tr("here after %1 s, there after %2 s")
          .arg(number(place.time, 3), number(place.time - place.lost, 3)),
      Scene::tr("paths %1 µm apart").arg(number(1000 * place.distance, 1))}
      .join('\n');
}

std::vector<std::string> measurement_lines(const State& from, const State& to) {
  const Vec3 delta = to.position - from.position;
  const QStringList lines{
      Scene::tr("Distance %1 mm").arg(number(delta.norm(), 4)),
      Scene::tr("dX %1   dY %2   dZ %3 mm")
          .arg(number(delta.x(), 3), number(delta.y(), 3), number(delta.z(), 3)),
      Scene::tr("Path length %1 mm").arg(number(std::abs(to.path_length - from.path_length), 3)),
      Scene::tr("Time %1 s").arg(number(std::abs(to.time - from.time), 4))};
  std::vector<std::string> texts;
  for (const QString& line : lines) {
    texts.push_back(line.toStdString());
  }
  return texts;
}

}  // namespace feedscope::ui
