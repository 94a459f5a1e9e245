#include "ui/circular/circular_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <numbers>

#include "core/base/error.h"
#include "core/base/units.h"

namespace feedscope::ui {

namespace {

struct CircularTexts {
  Q_DECLARE_TR_FUNCTIONS(CircularTexts)
};

/// Translates program_circle_notes().
QStringList notes_of(const ProgramCircles& circles) {
  const QLocale locale;
  QStringList notes;
  if (circles.found == 0) {
    notes.append(CircularTexts::tr(
        "The program has no full circle: no cut runs a whole turn in XY, ZX or YZ by arcs about one centre. "
        "Circles of short lines are not recognised."));
  }
  if (circles.evaluated < circles.found) {
    notes.append(CircularTexts::tr("The program has %1 full circles; the first %2 are evaluated.")
                     .arg(locale.toString(circles.found), locale.toString(circles.evaluated)));
  }
  if (circles.helices > 0) {
    notes.append(CircularTexts::tr("Not evaluated: helices with full turns, %1.")
                     .arg(locale.toString(circles.helices)));
  }
  if (circles.tilted > 0) {
    notes.append(CircularTexts::tr("Not evaluated: full circles outside the planes XY, ZX and YZ, %1.")
                     .arg(locale.toString(circles.tilted)));
  }
  return notes;
}

}  // namespace

QString circular_message(const CircularResult& result) {
  QStringList parts;
  if (!result.tests.empty()) {
    parts.append(result.actual()
                     ? CircularTexts::tr("Actual path of the axes.")
                     : CircularTexts::tr("Set path: this machine has no drives. Give them in Machine, "
                                         "Drives."));
  }
  if (result.circles) {
    parts += notes_of(*result.circles);
  }
  return parts.join(QLatin1Char(' '));
}

QString circular_picture_title() {
  return CircularTexts::tr("Circular test (ISO 230-4)");
}

QString circular_picture_details(const Setup& setup, bool actual) {
  return CircularTexts::tr("%1, model %2, %3")
      .arg(QString::fromStdString(setup.machine.name), QString::fromStdString(setup.model->info().id),
           actual ? CircularTexts::tr("actual path of the axes")
                  : CircularTexts::tr("set path: the machine has no drives"));
}

std::vector<CircularRequest> requests_of(const CircularState& state) {
  const std::size_t count = state.radii.size() * state.feeds.size();
  if (count > max_circular_tests) {
    throw InputError(CircularTexts::tr("%1 radii and %2 feeds are %3 tests; a table has at most %4. Type "
                                       "fewer.")
                         .arg(state.radii.size())
                         .arg(state.feeds.size())
                         .arg(count)
                         .arg(max_circular_tests)
                         .toStdString());
  }
  std::vector<CircularRequest> requests;
  for (const double radius : state.radii) {
    for (const double feed : state.feeds) {
      requests.push_back({radius, units::from_mm_min(feed), state.plane, 0, 2 * std::numbers::pi,
                          state.entry_arc ? state.entry_radius : 0});
    }
  }
  return requests;
}

}  // namespace feedscope::ui
