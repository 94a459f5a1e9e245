#include "ui/study/study_curves.h"

#include <QLocale>

#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/study/study_chart.h"

namespace feedscope::ui {

StudyCurves study_curves(const Study& study) {
  StudyCurves shown;
  shown.within = study.within;
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
    const Setup& setup = runs.front().setup;
    curve.name = QString::fromStdString(setup.model->info().id + ", " + setup.machine.id);
    for (std::size_t i = 1; i < study.sweeps.size(); ++i) {
      curve.name += QStringLiteral(", %1 %2").arg(setting_title(study.sweeps[i].key),
                                                  QLocale().toString(runs.front().swept[i], 'g', 4));
    }
    if (const std::size_t lines = runs.front().lines_not_run; lines > 0) {
      curve.name += StudyChart::tr(", refused lines: %1").arg(lines);
    }
    const std::vector<bool> marks = fastest_marks(runs, study.within);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const StudyRun& run = runs[i];
      if (!run.is_possible()) {
        continue;
      }
      if (marks[i]) {
        curve.fastest.push_back(curve.points.size());
      }
      curve.points.push_back(
          {run.swept.front() * unit.factor, run.summary.cycle_time, run.summary.cutting_contour_error});
    }
    if (!curve.points.empty()) {
      shown.curves.push_back(std::move(curve));
    }
  }
  return shown;
}

}  // namespace feedscope::ui
