#pragma once

#include <QList>
#include <QWidget>

#include "ui/models/workbench.h"
#include "ui/views/scene_view.h"

class QComboBox;
class QSplitter;

namespace feedscope::ui {

/// The 3D view of the current run and, if wanted, that of another one beside it: turned, coloured and
/// enlarged alike, the tool of both at the same place of the program.
class SideBySide : public QWidget {
  Q_OBJECT

 public:
  /// `first` shows the current run and becomes a part of this. `model` outlives this.
  SideBySide(Workbench& model, SceneView& first, RenderBackend backend, QWidget* parent = nullptr);

  void set_on(bool on);
  bool on() const { return second_ != nullptr; }
  /// Null while there is one view alone.
  SceneView* second() { return second_; }
  /// Which run stands beside the current one.
  QComboBox* choice() { return choice_; }
  QList<QAction*> panel_actions() const { return {action_}; }

 private:
  void open();
  void close();
  void list_runs();
  void show_run();
  void show_cursor();
  void link(SceneView& from, SceneView& to);
  std::size_t other_row() const;

  Workbench& model_;
  SceneView& first_;
  RenderBackend backend_;
  QSplitter* splitter_;
  QAction* action_;
  QWidget* side_ = nullptr;  ///< the second view with the choice of its run
  SceneView* second_ = nullptr;
  QComboBox* choice_ = nullptr;
  std::shared_ptr<const ShownRun> shown_;  ///< in the second view
  bool linking_ = false;
};

}  // namespace feedscope::ui
