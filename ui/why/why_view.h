#pragma once

#include <QList>
#include <QTimer>
#include <memory>
#include <optional>

#include "ui/shared/cursor.h"
#include "ui/why/remedy_table.h"
#include "ui/workbench/panel.h"
#include "ui/workbench/setup_state.h"
#include "ui/workbench/shown_run.h"

class QAction;
class QLabel;
class QPushButton;
class QTableView;
class QToolButton;

namespace feedscope::ui {

/// Why the tool is not faster at the cursor: the limiting cause in a sentence with its numbers and formula,
/// the slower place ahead, the causes before and after, and what would help, tried by simulating it.
///
/// Moving the cursor simulates nothing. Changes are tried when asked for, or by themselves once the cursor
/// rests, where the program is short enough.
class WhyView : public Panel {
  Q_OBJECT

 public:
  /// `cursor` outlives this.
  explicit WhyView(Cursor& cursor, QWidget* parent = nullptr);

  void follow(Workbench& workbench) override;
  /// The run that the cursor points into, and the setup that it was made with; null: none.
  void set_run(std::shared_ptr<const ShownRun> shown, const SetupState& setup);

  /// Null for none.
  const std::shared_ptr<const ShownRun>& shown() const { return shown_; }

  /// Whether the panel can be seen when it is shown: not while another one lies on top of it.
  void set_on_screen(bool on_screen) override;
  bool is_seen() const { return on_screen_ && isVisible(); }

  /// Tries what would help at the cursor.
  void try_remedies();
  bool busy() const override { return job_.busy(); }

  /// To the causes before and after, to the slower place ahead, what would help, a run with the change.
  QList<QAction*> panel_actions() const override { return actions_; }
  RemedyTable& remedies() { return *table_model_; }
  QTableView* table() { return table_; }
  /// What is shown, as plain text.
  QString cause_text() const;
  QString sentence_text() const;
  /// What the drives do here; empty where they make little of the contour error.
  QString drives_text() const;
  QString formula_text() const;

 signals:
  /// A place that has been chosen [s].
  void time_chosen(double time);
  /// A run with this setup is wanted beside the current one.
  void run_wanted(const feedscope::ui::SetupState& setup);

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// What has no room in the panel is in the tips of the buttons.
  void fit_buttons();
  QLabel* add_label(QWidget* parent);
  QAction* add_action(const QString& text, const QString& tip, const QKeySequence& key,
                      void (WhyView::*call)());
  QToolButton* add_button(QAction* action);
  void make_actions();
  void make_table();
  void lay_out();
  void note_change();
  void catch_up();
  void show_place();
  void show_nothing();
  void show_reason(const Explanation& why);
  void show_ahead(const Explanation& why);
  void show_neighbours();
  void find_stretch();
  void forget_remedies();
  void take_trial(std::size_t index, const RemedyTrial& trial);
  void show_table_state();
  void fit_table();
  void go_before();
  void go_after();
  void go_ahead();
  void want_run();
  SegmentRange segments_here() const;
  const Trajectory& trajectory() const { return *shown_->run.trajectory; }

  Cursor& cursor_;
  std::shared_ptr<const ShownRun> shown_;
  std::optional<SetupState> setup_;
  std::optional<Explanation> why_;
  std::optional<CauseStretch> before_;
  std::optional<CauseStretch> stretch_;
  std::optional<CauseStretch> after_;
  Cause tried_for_;
  bool tried_ = false;
  bool on_screen_ = true;
  bool stale_ = true;

  RemedyJob job_;
  RemedyTable* table_model_;
  QTimer rest_;  ///< until the cursor counts as resting

  QLabel* heading_;
  QLabel* place_;
  QLabel* sentence_;
  QLabel* drives_;
  QLabel* formula_;
  QLabel* source_;
  QWidget* ahead_box_;
  QLabel* ahead_heading_;
  QLabel* ahead_sentence_;
  QLabel* ahead_formula_;
  QLabel* ahead_source_;
  QToolButton* before_button_;
  QToolButton* after_button_;
  QToolButton* ahead_button_;
  QPushButton* help_;
  QLabel* help_state_;
  QTableView* table_;
  QPushButton* new_run_;
  QList<QAction*> actions_;
  QAction* before_action_ = nullptr;
  QAction* after_action_ = nullptr;
  QAction* ahead_action_ = nullptr;
  QAction* help_action_ = nullptr;
  QAction* run_action_ = nullptr;
};

}  // namespace feedscope::ui
