#pragma once

#include <QByteArray>
#include <QString>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/program/program.h"
#include "ui/charts/charts_state.h"
#include "ui/circular/circular_state.h"
#include "ui/identification/identification_state.h"
#include "ui/lessons/lesson_work.h"
#include "ui/scene/scene_state.h"
#include "ui/scene_view/scenes_state.h"
#include "ui/theme/theme.h"
#include "ui/workbench/annotation.h"
#include "ui/workbench/run_list.h"
#include "ui/workbench/trace_item.h"

namespace feedscope::ui {

/// The user's work on one program, as stored in a session file.
struct Session {
  std::filesystem::path program;  ///< absolute; relative to the session in its file
  QByteArray program_hash;        ///< SHA-256 of the program's bytes, in hex; empty: unknown
  ReadOptions reading;            ///< of the program; a tool table's path is absolute
  std::vector<RunItem> runs;      ///< at least one
  std::size_t current_run = 0;
  double cursor = 0;                  ///< time in the current run [s]
  std::optional<double> error_bound;  ///< RunList::error_bound() [mm]
  SceneState scene;
  ScenesState scenes;
  ChartsState charts;
  CircularState circular;
  LoadSetup load;  ///< engagement of the tools; may not fit the program
  std::vector<Annotation> annotations;
  std::vector<TraceItem> traces;         ///< absolute paths; missing files are kept
  IdentificationState identification;    ///< refers to rows of `runs` and `traces`
  LessonWork lessons;                    ///< predictions, answers and tried values
  bool lessons_unlocked = false;         ///< whether lessons show their run without a prediction
  QByteArray layout;                     ///< of the docks, as QMainWindow::saveState; may be empty
  bool presentation = false;             ///< large type and few panels; `layout` is without it
  std::optional<ThemeKind> theme;        ///< none: the preference of the user who opens it
  std::optional<int> program_font_size;  ///< [pixels]
};

}  // namespace feedscope::ui
