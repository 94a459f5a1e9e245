#pragma once

#include <QList>
#include <filesystem>

#include "core/base/diagnostic.h"
#include "ui/workbench/panel.h"
#include "ui/workbench/workbench.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QSplitter;
class QStandardItemModel;
class QTreeView;

namespace feedscope::ui {

/// A recorded trace of the program compared with the current run: their agreement in a sentence and in
/// figures, and the places and corners with differences, to go to.
class TraceView : public Panel {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit TraceView(Workbench& workbench, QWidget* parent = nullptr);

  /// Whether a file looks like a trace: rows of samples, not the text of a program.
  static bool is_trace(const std::filesystem::path& file);
  /// Adds a trace to the program. Asks for its columns if they cannot be detected.
  void open(const std::filesystem::path& file);
  void ask_for_file();
  /// Shows the trace of this row of the list.
  void choose(std::size_t row);

  bool busy() const override { return workbench_.traces().busy(); }
  QList<QAction*> panel_actions() const override { return actions_; }
  QString verdict() const;
  QTreeView& figures() { return *figures_view_; }
  QTreeView& places() { return *places_view_; }
  QTreeView& corners() { return *corners_view_; }

 signals:
  /// The user has chosen a place: `time` of the current run there, which is between `from` and `to` [s].
  void place_chosen(double time, double from, double to);
  /// A trace has been compared, with this message on it.
  void noted(Severity severity, const QString& message);

 private:
  void make_actions();
  void make_layout();
  QTreeView* add_table(QStandardItemModel* model, const QString& name);
  void ask_for_columns(const std::filesystem::path& file, const QString& reason);
  void change_columns();
  void list_traces();
  void refresh();
  void show_result();
  void show_progress();
  void go_to(const QModelIndex& index);
  void tell_faults(std::size_t row);
  void save();
  bool any() const { return !workbench_.traces().items().empty(); }

  Workbench& workbench_;
  QComboBox* which_;
  QLabel* verdict_;
  QLabel* remarks_;
  QProgressBar* progress_;
  QSplitter* tables_;
  QStandardItemModel* figures_;
  QStandardItemModel* places_;
  QStandardItemModel* corners_;
  QTreeView* figures_view_ = nullptr;
  QTreeView* places_view_ = nullptr;
  QTreeView* corners_view_ = nullptr;
  QList<QAction*> actions_;
  QList<QAction*> of_trace_;              ///< require one
  std::size_t chosen_ = 0;                ///< row
  std::weak_ptr<const ShownTrace> seen_;  ///< contents of the tables
};

}  // namespace feedscope::ui
