#pragma once

#include <QColor>
#include <QDateTime>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "core/analysis/circularity/program_circles.h"
#include "core/analysis/compare.h"
#include "core/analysis/contour/contour_report.h"
#include "core/analysis/time_use/time_report.h"
#include "ui/charts/charts_state.h"
#include "ui/identification/identification_state.h"
#include "ui/scene/scene_state.h"
#include "ui/scene/scene_style.h"
#include "ui/workbench/annotation.h"
#include "ui/workbench/shown_run.h"
#include "ui/workbench/trace_list.h"

namespace feedscope::ui {

/// A sheet that a report is laid out on [1/96 inch].
struct Paper {
  double width = 210 / 25.4 * 96;  ///< A4 at first
  double height = 297 / 25.4 * 96;

  static constexpr double margin_top = 62;
  static constexpr double margin_bottom = 60;
  /// Of what is between the margins.
  double contents_height() const { return height - margin_top - margin_bottom; }
};
inline constexpr Paper letter_paper{8.5 * 96, 11.0 * 96};

/// One of the runs that sheet and report show.
struct ReportRun {
  std::shared_ptr<const ShownRun> shown;
  QString name;  ///< unlike those of the others
  QColor colour;
  std::shared_ptr<const ContourReport> contour = nullptr;  ///< until with_contour_reports()
};

inline const Summary& summary_of(const ReportRun& run) {
  return run.shown->run.summary;
}

/// A run that was asked for and cannot be simulated.
struct UnmadeRun {
  QString name;
  Message why;
};

/// What a control recorded of the program.
struct ReportTrace {
  std::shared_ptr<const ShownTrace> shown;  ///< beside the current run
  QString name;
  QColor colour;
};

/// Everything that pictures, sheet and report are made of; a session or the options of the command line fill
/// it. The same input gives the same bytes.
struct ReportInput {
  std::vector<ReportRun> runs;  ///< of one program, at least one
  std::size_t current = 0;      ///< the one that 3D view, charts and worst places show
  std::vector<UnmadeRun> unmade;
  std::vector<ReportTrace> traces;
  IdentificationResult identification;  ///< of a machine from recordings of the program; may be none
  SceneState scene;                     ///< how the 3D view looks
  SceneTexts texts;                     ///< that stand in it; at first English
  std::optional<double> cursor;         ///< where the stretch of `scene` ends that is drawn up to it [s]
  /// Run that the colours of `scene` compare with; none: the first other one than what is shown.
  std::optional<std::size_t> reference;
  /// Looks from there at the whole path, instead of with the camera of `scene`.
  std::optional<StandardView> view = StandardView::iso;
  std::vector<Annotation> annotations;
  /// Range and curves; at first all of the run, and the achieved feed of the others.
  ChartsState charts{.other_runs = {QStringLiteral("feed")}};
  QString title;         ///< empty: the program's name
  QString author;        ///< may be empty
  QDateTime date;        ///< invalid: no date is written
  QString remarks;       ///< words of the author's own; an empty line begins a new paragraph
  QString logo;          ///< data: URL of a picture as inline_picture_url(); may be empty
  QStringList commands;  ///< command lines that make this again
  QStringList without;   ///< placeholders of the template that stay empty
  /// Sections of the template that are not omitted, as ReportTemplate::filled(); without these two the report
  /// is brief.
  QStringList with{QStringLiteral("motion"), QStringLiteral("trust")};
  /// Largest contour error of a run that may be recommended [mm].
  std::optional<double> within;
  std::size_t tolerances_asked = 0;  ///< 0: not known
  Paper paper = {};
  /// Of the current run; until with_circles().
  std::shared_ptr<const ProgramCircles> circles = nullptr;
  /// Of the current run; until with_time_report().
  std::shared_ptr<const TimeReport> time = nullptr;

  const ReportRun& run() const { return runs[current]; }
  const LoadedProgram& program() const { return runs.front().shown->run.input; }
  QString heading() const;
};

/// The program's file without its folders.
QString program_file_name(const Program& program);

/// The same with the contour report of every run. Throws Cancelled if `progress` is cancelled.
ReportInput with_contour_reports(ReportInput input, Progress* progress = nullptr);

/// What of the names of the runs is not the same in all: "0.02 mm"; the whole name where nothing is.
QStringList short_names(const ReportInput& input);
/// What is the same in all: "essid"; all of the name of a single run.
QString common_name(const ReportInput& input);
/// The figures of the runs, in their order.
std::vector<ComparedRun> run_figures(const ReportInput& input);
/// The input with the recommended run as its current one, unless something else belongs to the current one:
/// recordings, or a stretch of its time.
ReportInput with_recommended_run(ReportInput input);

/// Runs that nobody has named or coloured: what tells them apart as the name ("essid, 0.01 mm"), colours told
/// apart with every kind of colour vision.
std::vector<ReportRun> report_runs(const std::vector<std::shared_ptr<const ShownRun>>& runs);

}  // namespace feedscope::ui
