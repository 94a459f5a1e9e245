#pragma once

#include <QList>
#include <QWidget>

#include "ui/models/run_table.h"

class QAction;
class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QTableView;

namespace feedscope::ui {

/// The runs of the program with their results: choose the current one, duplicate and change it, hide,
/// reorder, remove; and which is the fastest within a bound on the contour error.
class RunsView : public QWidget {
  Q_OBJECT

 public:
  /// `runs` outlives this.
  explicit RunsView(RunList& runs, QWidget* parent = nullptr);

  QTableView* table() { return table_; }
  RunTable& results() { return *model_; }
  /// Duplicate, variants, remove, up, down.
  QList<QAction*> panel_actions() const { return actions_; }
  /// Which run is the fastest, in one sentence.
  QString verdict() const;

 private:
  void make_actions();
  void add_variants();
  void add_action(const QString& text, const QString& tip, const QKeySequence& key, void (RunsView::*call)());
  void duplicate();
  void remove();
  void move_up();
  void move_down();
  void choose_colour(std::size_t row);
  void follow_current();
  void show_verdict();

  RunList& runs_;
  RunTable* model_;
  QTableView* table_;
  QCheckBox* bounded_;
  QDoubleSpinBox* bound_;
  QLabel* verdict_;
  QList<QAction*> actions_;
};

}  // namespace feedscope::ui
