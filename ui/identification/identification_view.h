#pragma once

#include <QList>
#include <filesystem>
#include <memory>

#include "ui/identification/identification_job.h"
#include "ui/identification/identification_state.h"
#include "ui/workbench/panel.h"
#include "ui/workbench/workbench.h"

class QAction;
class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace feedscope::ui {

class FitChoice;
class RecordingsBox;
class ResultBox;
class TestProgramDialog;

/// Limits and settings of the user's machine from what it recorded, in four steps: the recordings, what is
/// fitted to them, the search, and what it has found, which becomes a run or a machine file.
class IdentificationView : public Panel {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit IdentificationView(Workbench& workbench, QWidget* parent = nullptr);

  QList<QAction*> panel_actions() const override { return actions_; }
  bool busy() const override { return job_.busy(); }
  void set_on_screen(bool on_screen) override;

  /// A table of section times of the program; what is wrong with it is said below.
  void add_table(const std::filesystem::path& file);
  /// Begins the search with what is chosen, unless something is missing.
  void identify();
  void cancel() { job_.cancel(); }
  /// Adds a run on the machine that the chosen model has found, as the current one.
  void show_as_run();
  /// As `feedscope identify --out` writes it.
  void save_machine(const std::filesystem::path& file);
  /// Asks what the test program is to be.
  TestProgramDialog& ask_for_test_program();

  /// What is chosen and found, without a search that is under way.
  IdentificationState state() const;
  /// Needs the runs and traces that it speaks of. A result that was up to date is so again where program,
  /// recordings and machine are still the same.
  void set_state(const IdentificationState& state);

  RecordingsBox& recordings() { return *recordings_; }
  FitChoice& choice() { return *choice_; }
  ResultBox& result() { return *result_; }
  QPushButton& identify_button() { return *identify_; }
  /// What is missing, under way, done or wrong.
  QString message() const;

 signals:
  /// The trace of the program is to be opened.
  void trace_wanted();
  /// The test program is to be opened.
  void program_wanted(const std::filesystem::path& file);

 private:
  void make_actions();
  void make_layout();
  QLabel* add_step(QVBoxLayout& layout, int number, const QString& title);
  IdentificationRequest request() const;
  QString missing(const IdentificationRequest& asked) const;
  void follow_program();
  void follow_recordings();
  void follow_input();
  void settle(const IdentificationRequest& asked);
  void take(std::shared_ptr<const IdentificationOutcome> outcome);
  void say(const QString& message);
  void ask_for_table();
  void ask_for_machine_file();

  Workbench& workbench_;
  IdentificationJob job_;
  RecordingsBox* recordings_;
  FitChoice* choice_;
  ResultBox* result_;
  QPushButton* identify_;
  QProgressBar* progress_;
  QLabel* state_;
  QScrollArea* scroll_;
  QLabel* search_heading_ = nullptr;
  QAction* open_trace_ = nullptr;
  QAction* open_table_ = nullptr;
  QAction* write_program_ = nullptr;
  QAction* show_run_ = nullptr;
  QAction* save_ = nullptr;
  QList<QAction*> actions_;
  std::filesystem::path file_;      ///< of the program that the tables are of
  IdentificationRequest searched_;  ///< by the search under way
  IdentificationRequest asked_;     ///< that the result is of
  bool unsettled_ = false;          ///< whether the result is of what is chosen is not known yet
  bool stale_ = false;              ///< it is not
};

}  // namespace feedscope::ui
