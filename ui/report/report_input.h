#pragma once

#include <QColor>
#include <QDateTime>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "core/analysis/circularity/program_circles.h"
#include "core/analysis/contour/contour_report.h"
#include "core/analysis/study/compare.h"
#include "core/analysis/time/time_report.h"
#include "ui/charts/charts_state.h"
#include "ui/identification/identification_state.h"
#include "ui/scene/scene_state.h"
#include "ui/scene/scene_style.h"
#include "ui/workbench/annotation.h"
#include "ui/workbench/shown_run.h"
#include "ui/workbench/trace_list.h"

namespace feedscope::ui {

/// Paper size of a report's layout [1/96 inch].
struct Paper {
  double width = 210 / 25.4 * 96;  ///< initially A4
  double height = 297 / 25.4 * 96;

  static constexpr double margin_top = 62;
  static constexpr double margin_bottom = 60;
  /// Height between the margins.
  double contents_height() const { return height - margin_top - margin_bottom; }
};
inline constexpr Paper letter_paper{8.5 * 96, 11.0 * 96};

/// One of the runs in sheet and report.
struct ReportRun {
  std::shared_ptr<const ShownRun> shown;
  QString name;  ///< unique among the runs
  QColor colour;
  std::shared_ptr<const ContourReport> contour = nullptr;  ///< until with_contour_reports()
};

inline const Summary& summary_of(const ReportRun& run) {
  return run.shown->run.summary;
}

/// A requested run that cannot be simulated.
struct UnmadeRun {
  QString name;
  Message why;
};

/// A recorded trace of the program.
struct ReportTrace {
  std::shared_ptr<const ShownTrace> shown;  ///< matched to the current run
  QString name;
  QColor colour;
};

/// Input of pictures, sheet and report, from a session or the options of the command line. The same input
/// gives the same bytes.
struct ReportInput {
  std::vector<ReportRun> runs;  ///< of one program, at least one
  std::size_t current = 0;      ///< the run in 3D view, charts and worst places
  std::vector<UnmadeRun> unmade;
  std::vector<ReportTrace> traces;
  IdentificationResult identification;  ///< of a machine from recordings of the program; may be empty
  SceneState scene;                     ///< appearance of the 3D view
  SceneTexts texts;                     ///< of the 3D view; initially English
  std::optional<double> cursor;         ///< end of the range of `scene` that is drawn up to it [s]
  /// Run that the colours of `scene` compare with; none: the first one other than the shown run.
  std::optional<std::size_t> reference;
  /// View of the whole path from there, instead of the camera of `scene`.
  std::optional<StandardView> view = StandardView::iso;
  std::vector<Annotation> annotations;
  /// Range and curves; initially the whole run, and the achieved feed of the others.
  ChartsState charts{.other_runs = {QStringLiteral("feed")}};
  QString title;         ///< empty: the program's name
  QString author;        ///< may be empty
  QDateTime date;        ///< invalid: no date
  QString remarks;       ///< the author's words; an empty line begins a new paragraph
  QString logo;          ///< data URL of a picture as inline_picture_url(); may be empty
  QStringList commands;  ///< command lines that reproduce this
  QStringList without;   ///< placeholders of the template that remain empty
  /// Included sections of the template, as ReportTemplate::filled(); without these two the report is brief.
  QStringList with{QStringLiteral("motion"), QStringLiteral("trust")};
  /// Largest contour error of a run that may be recommended [mm].
  std::optional<double> within;
  std::size_t tolerances_asked = 0;  ///< 0: unknown
  Paper paper = {};
  /// Of the current run; null until with_circles().
  std::shared_ptr<const ProgramCircles> circles = nullptr;
  /// Of the current run; null until with_time_report().
  std::shared_ptr<const TimeReport> time = nullptr;

  const ReportRun& run() const { return runs[current]; }
  const LoadedProgram& program() const { return runs.front().shown->run.input; }
  QString heading() const;
};

/// The program's file without its folders.
QString program_file_name(const Program& program);

/// `input` with the contour report of every run. Throws Cancelled if `progress` is cancelled.
ReportInput with_contour_reports(ReportInput input, Progress* progress = nullptr);

/// The differing parts of the runs' names: "0.02 mm"; the whole name if none differs.
QStringList short_names(const ReportInput& input);
/// What pictures and tables call a run: "B 0.02 mm"; of a single run its name.
QString lettered_title(const ReportInput& input, std::size_t run);
/// What is the same in all: "essid"; all of the name of a single run.
QString common_name(const ReportInput& input);
/// The figures of the runs, in their order.
std::vector<ComparedRun> run_figures(const ReportInput& input);
/// `input` with the leading_run() as its current one, unless something else depends on the current run:
/// recordings, or a range of its time.
ReportInput with_recommended_run(ReportInput input);

/// Runs without a name or colour of their own: the name is what distinguishes them ("essid, 0.01 mm"), and
/// the colours are distinct for every kind of colour vision.
std::vector<ReportRun> report_runs(const std::vector<std::shared_ptr<const ShownRun>>& runs);

}  // namespace feedscope::ui
