#pragma once

#include <QColor>
#include <QDateTime>
#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ui/models/shown_run.h"
#include "ui/scene/path_scene.h"
#include "ui/theme/theme.h"

class QPainter;

namespace feedscope::ui {

/// One of the runs that sheet and report show.
struct ReportRun {
  std::shared_ptr<const ShownRun> shown;
  QString name;  ///< unlike those of the others
  QColor colour;
};

/// How the 3D view looks at the run.
struct SceneLook {
  StandardView view = StandardView::iso;
  std::optional<CameraState> camera;  ///< instead of `view`
  Colouring colouring = Colouring::feed;
  double exaggeration = 1;
  ToolShape tool{};  ///< drawn only where a cursor is
  bool grid = true;
  bool overlays = true;  ///< the other runs, thin
};

/// Paints over a 3D view of the current run that has just been drawn. The painter's units are those of the
/// whole picture, with the view's upper left corner at 0, 0; `size`: of the view in these units; pixels of
/// `scene` are `pixel_ratio` times as many. `text_scale`: size of text and lines, 1 for 96 units an inch.
struct SceneCanvas {
  QPainter& painter;
  const PathScene& scene;
  QSizeF size;
  double pixel_ratio = 1;
  double text_scale = 1;
  ThemeKind theme = ThemeKind::light;
};
using AnnotationPainter = std::function<void(const SceneCanvas&)>;

/// Everything that pictures, sheet and report are made of; a session or the options of the command line fill
/// it. The same input gives the same bytes.
struct ReportInput {
  std::vector<ReportRun> runs;  ///< of one program, at least one
  std::size_t current = 0;      ///< the one that 3D view, charts and worst places show
  SceneLook scene;
  AnnotationPainter annotations;  ///< null: none
  QStringList notes;              ///< the texts of the annotations, for the report's list of them
  QJsonObject charts;             ///< as ChartsPanel::state(); empty: all of the run
  QString title;                  ///< empty: the program's name
  QString author;                 ///< may be empty
  QDateTime date;                 ///< invalid: no date is written
  QStringList commands;           ///< command lines that make this again

  const ReportRun& run() const { return runs[current]; }
  const LoadedProgram& program() const { return runs.front().shown->run.input; }
  QString heading() const;
};

/// The program's file without its folders.
QString program_file_name(const Program& program);

/// Runs that nobody has named or coloured: what tells them apart as the name ("essid, 0.01 mm"), colours told
/// apart with every kind of colour vision.
std::vector<ReportRun> report_runs(const std::vector<std::shared_ptr<const ShownRun>>& runs);

}  // namespace feedscope::ui
