#include "ui/study/study_curves.h"

#include <QLocale>
#include <algorithm>

#include "core/analysis/study/recommendation.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/study/study_chart.h"

namespace feedscope::ui {

QString family_name(const Study& study, const StudyRun& run) {
  QString name = QString::fromStdString(run.setup.model->info().id + ", " + run.setup.machine.id);
  const bool swept = std::ranges::find(study.sweeps, "tolerance", &Sweep::key) != study.sweeps.end();
  const std::optional<double> tolerance = contour_tolerance(run.setup);
  const bool differs = std::ranges::any_of(study.runs, [&](const StudyRun& other) {
    const std::optional<double> its = contour_tolerance(other.setup);
    return its && its != tolerance;
  });
  if (tolerance && differs && !swept) {
    name += QStringLiteral(", ") + significant_text(*tolerance, Dimension::length, 4);
  }
  for (std::size_t i = 2; i < study.sweeps.size(); ++i) {
    const KeyUnit unit = key_unit(sweep_unit(study.sweeps[i].key));
    name += QStringLiteral(", %1 %2 %3")
                .arg(setting_title(study.sweeps[i].key),
                     QLocale().toString(run.swept[i] * unit.factor, 'g', 4), unit.text);
  }
  return name.trimmed();
}

bool errors_are_actual(const Study& study) {
  return std::ranges::all_of(study.runs, [](const StudyRun& run) { return run.summary.actual.has_value(); });
}

StudyCurves study_curves(const Study& study) {
  StudyCurves shown;
  shown.within = study.within;
  shown.actual = errors_are_actual(study);
  if (study.sweeps.empty()) {
    return shown;
  }
  const Sweep& first = study.sweeps.front();
  shown.title = setting_title(first.key);
  const KeyUnit unit = key_unit(sweep_unit(first.key));
  shown.unit = unit.text;
  shown.logarithmic = first.logarithmic;
  for (const auto& runs : study.curves()) {
    StudyCurve curve;
    curve.name = family_name(study, runs.front());
    if (const std::size_t lines = runs.front().lines_not_run; lines > 0) {
      curve.name += StudyChart::tr(", refused lines: %1").arg(lines);
    }
    const std::vector<bool> marks = recommended_marks(runs, study.within);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const StudyRun& run = runs[i];
      if (!run.is_possible()) {
        continue;
      }
      if (marks[i]) {
        curve.best.push_back(curve.points.size());
      }
      curve.points.push_back(
          {run.swept.front() * unit.factor, run.summary.cycle_time, deciding_error(run.summary)});
    }
    if (!curve.points.empty()) {
      shown.curves.push_back(std::move(curve));
    }
  }
  return shown;
}

}  // namespace feedscope::ui
