#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/analysis/difference/program_difference.h"
#include "ui/shared/job.h"
#include "ui/workbench/panel.h"
#include "ui/workbench/shown_run.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace feedscope::ui {

/// An older version of the program compared with the open one, on the setup of the current run: the changes
/// of the path, and the largest differences of time. A row leads to its place in the open program.
class VersionsView : public Panel {
  Q_OBJECT

 public:
  explicit VersionsView(QWidget* parent = nullptr);

  void follow(Workbench& workbench) override;
  QList<QAction*> panel_actions() const override { return {compare_}; }
  bool busy() const override { return job_.busy(); }
  /// Reads and simulates it on another thread, again after each change of the current run.
  void compare_with(const std::filesystem::path& older);
  void cancel() { job_.cancel(); }

  /// Null until it is computed.
  const ProgramDifference* difference() const { return found_ ? &found_->difference : nullptr; }
  QTreeWidget& tree() { return *tree_; }
  QString conclusion() const;

 signals:
  /// In the run of the open program [s].
  void place_chosen(double time, double from, double to);

 private:
  struct Found {
    Run old;
    ProgramDifference difference;
  };

  void ask();
  void begin();
  void show_found();
  void add_sums();
  void add_places();
  void choose(const QTreeWidgetItem* item);
  void show_state(const QString& failure);

  Workbench* workbench_ = nullptr;
  QLabel* conclusion_;
  QTreeWidget* tree_;
  QProgressBar* progress_;
  QPushButton* choose_;
  QAction* compare_;
  std::filesystem::path older_;  ///< empty: no comparison
  std::shared_ptr<const ShownRun> shown_;
  std::optional<Found> found_;
  Job<Found> job_;
};

}  // namespace feedscope::ui
