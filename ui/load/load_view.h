#pragma once

#include <QList>

#include "core/load/load_file.h"
#include "ui/workbench/panel.h"
#include "ui/workbench/workbench.h"

class QAction;
class QComboBox;
class QLabel;
class QSplitter;
class QTableView;

namespace feedscope::ui {

class LoadFiguresTable;
class LoadPlacesTable;
class OperationTable;

/// Engagement of the program's tools, editable, and the resulting load in the current run. Input applies to
/// all runs as soon as it fits the program; other input remains in the table, with a message.
class LoadView : public Panel {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit LoadView(Workbench& workbench, QWidget* parent = nullptr);

  /// Contents of the table, even if they do not fit the program; for sessions.
  const LoadSetup& setup() const;
  void set_setup(const LoadSetup& setup);
  void open_file(const QString& file);
  void save_file(const QString& file);
  QList<QAction*> panel_actions() const override { return actions_; }

  QTableView* operations() { return operations_; }
  QTableView* figures() { return figures_; }
  QTableView* places() { return places_; }
  QComboBox* shown_operation() { return which_; }
  OperationTable* table() { return table_; }
  /// The message of the panel: on the load, or an error.
  QString message() const;

 private:
  void make_actions();
  void make_layout();
  void apply();
  void follow_program();
  void follow_load();
  void show_result();
  void show_totals();
  void say(const QString& message, bool wrong);
  void ask_to_open();
  void ask_to_save();

  Workbench& workbench_;
  OperationTable* table_;
  LoadFiguresTable* figures_table_;
  LoadPlacesTable* places_table_;
  QTableView* operations_;
  QTableView* figures_;
  QTableView* places_;
  QComboBox* which_;
  QLabel* message_;
  QAction* add_ = nullptr;
  QAction* remove_ = nullptr;
  QList<QAction*> actions_;
  LoadSetup applied_;  ///< of the runs
  bool applying_ = false;
  QString problem_;  ///< reason why the table is not applied; empty if it is
};

}  // namespace feedscope::ui
