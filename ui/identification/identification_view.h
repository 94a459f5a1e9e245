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

/// Limits and settings of the user's machine from its recordings, in four steps: the recordings, the models
/// and numbers, the search, and the result, which becomes a run or a machine file.
class IdentificationView : public Panel {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit IdentificationView(Workbench& workbench, QWidget* parent = nullptr);

  QList<QAction*> panel_actions() const override { return actions_; }
  bool busy() const override { return job_.busy(); }
  void set_on_screen(bool on_screen) override;

  /// Adds a table of section times of the program; shows errors in it below.
  void add_table(const std::filesystem::path& file);
  /// Starts the search with the current choices, unless something is missing.
  void identify();
  void cancel() { job_.cancel(); }
  /// Adds a run on the machine that the chosen model has found, and makes it current.
  void show_as_run();
  /// Writes the file of `feedscope identify --out`.
  void save_machine(const std::filesystem::path& file);
  /// Opens the dialog for the test program.
  TestProgramDialog& ask_for_test_program();

  /// Choices and results, without a running search.
  IdentificationState state() const;
  /// Requires its runs and traces. A result that was up to date is so again if program, recordings and
  /// machine are unchanged.
  void set_state(const IdentificationState& state);

  RecordingsBox& recordings() { return *recordings_; }
  FitChoice& choice() { return *choice_; }
  ResultBox& result() { return *result_; }
  QPushButton& identify_button() { return *identify_; }
  /// Message on missing input, progress, success or failure.
  QString message() const;

 signals:
  /// Requests to open the trace of the program.
  void trace_wanted();
  /// Requests to open the test program.
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
  std::filesystem::path file_;      ///< of the program that the tables belong to
  IdentificationRequest searched_;  ///< by the running search
  IdentificationRequest asked_;     ///< answered by the result
  bool unsettled_ = false;          ///< not yet known whether the result fits the current choices
  bool stale_ = false;              ///< whether the result does not fit them
};

}  // namespace feedscope::ui
