#include "ui/setup/run_notes_text.h"

#include <QCoreApplication>
#include <QLocale>

#include "core/analysis/notes/ignored_path_control.h"
#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/notes/run_notes.h"
#include "core/analysis/notes/unadvised_tolerance.h"
#include "core/analysis/notes/undetermined_limits.h"
#include "core/analysis/run/control_dialect.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"
#include "ui/language/texts.h"
#include "ui/language/unreachable_feed_text.h"
#include "ui/workbench/reading_faults.h"

namespace feedscope::ui {

namespace {

struct RunNotes {
  Q_DECLARE_TR_FUNCTIONS(RunNotes)
};

QString tolerance_text(const UnadvisedTolerance& unadvised) {
  const auto length = [](double value) { return significant_text(value, Dimension::length, 3); };
  const auto share = [](double value) { return QLocale().toString(qRound(100 * value)); };
  const bool range = unadvised.tolerance.is_range();
  const QString up_to = RunNotes::tr("%1 to %2");
  const QString tolerances = range
                                 ? up_to.arg(length(unadvised.tolerance.min), length(unadvised.tolerance.max))
                                 : length(unadvised.tolerance.min);
  const QString shares =
      range ? up_to.arg(share(unadvised.least), share(unadvised.largest)) : share(unadvised.least);
  return RunNotes::tr(
             "The contour tolerance of %1 is %2 % of the estimated chord error of the short lines "
             "(%3); Heidenhain advises 110 to 200 %.")
      .arg(tolerances, shares, significant_text(unadvised.chord_error, Dimension::length, 2));
}

}  // namespace

QStringList run_note_texts(const Run& run) {
  QStringList sentences;
  if (const auto mismatch = control_mismatch(run.setup.machine, run.input.program->dialect)) {
    const QString dialect = QString::fromUtf8(info_of(mismatch->dialect).title.data());
    sentences.append(
        RunNotes::tr("The program is written for %1; path and times are those of the %2 of this machine.")
            .arg(dialect, QString::fromStdString(mismatch->control)));
  }
  const std::string offsets = unused_work_offsets(*run.input.program, run.setup.machine);
  if (!offsets.empty()) {
    sentences.append(RunNotes::tr("The program was read with work offsets other than those of this machine "
                                  "(%1); reload it to use those of the machine.")
                         .arg(QString::fromStdString(offsets)));
  }
  for (const Message& sentence : ignored_path_control(run.input, run.setup)) {
    sentences.append(in_language(sentence));
  }
  for (const char* const note : figure_notes(*run.input.toolpath, run.setup)) {
    sentences.append(core_text(note));
  }
  if (const std::vector<Diagnostic>& refused = run.input.lines_not_run; !refused.empty()) {
    sentences.append(
        RunNotes::tr("Lines that the control refuses are not run: %1.").arg(in_language(line_list(refused))));
  }
  if (const std::vector<Diagnostic>& faults = run.input.toolpath->machine_faults; !faults.empty()) {
    sentences.append(RunNotes::tr("Rotary axes: line %1: %2.")
                         .arg(most_severe(faults).line)
                         .arg(in_language(most_severe(faults).message)));
  }
  if (const auto unadvised = unadvised_tolerance(run.input.chord_error,
                                                 tolerance_in_force(run.input.feed_controls, run.setup))) {
    sentences.append(tolerance_text(*unadvised));
  }
  if (const auto feed = feed_beyond_machine(run.input, *run.input.toolpath, run.setup)) {
    sentences.append(unreachable_feed_text(*feed));
  }
  for (const UndeterminedLimit& limit : undetermined_limits(run)) {
    sentences.append(
        RunNotes::tr("%1 limits %2 s of the cycle time (%3 %), but the recordings that the machine was "
                     "identified from do not determine it.")
            .arg(setting_title(limit.key), significant_number(limit.time, 3),
                 significant_number(100 * limit.share, 2)));
  }
  for (const PoorDamping& drive : poorly_damped(run.setup.machine)) {
    sentences.append(
        RunNotes::tr("The drive of axis %1 is poorly damped: it overshoots a step by %2 %; a smaller "
                     "gain or lag damps it better.")
            .arg(drive.axis)
            .arg(qRound(100 * drive.overshoot)));
  }
  if (const std::string axes = axes_without_drive(run.setup.machine); !axes.empty()) {
    sentences.append(
        RunNotes::tr("No drive is given for %1: followed exactly.").arg(QString::fromStdString(axes)));
  }
  if (const QString events = not_counted_text(run.summary.not_counted); !events.isEmpty()) {
    sentences.append(events + '.');
  }
  return sentences;
}

}  // namespace feedscope::ui
