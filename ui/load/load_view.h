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

/// How the tools of the program are engaged, to be edited, and what the current run puts on them. What is
/// typed holds for every run as soon as it fits the program; what does not is said, and stays in the table.
class LoadView : public Panel {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit LoadView(Workbench& workbench, QWidget* parent = nullptr);

  /// What the table says, whether it fits the program or not: for sessions.
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
  /// What the panel says: of the load, or what is wrong.
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
  LoadSetup applied_;  ///< what the runs have
  bool applying_ = false;
  QString problem_;  ///< why the table does not hold; empty: it does
};

}  // namespace feedscope::ui
