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

/// Reason why the tool is not faster at the cursor: the limiting cause in a sentence with its numbers and
/// formula, the slower place ahead, the causes before and after, and helpful changes, tried by simulation.
///
/// Moving the cursor simulates nothing. Changes are tried on request, or when the cursor is at rest and the
/// program is short enough.
class WhyView : public Panel {
  Q_OBJECT

 public:
  /// `cursor` outlives this.
  explicit WhyView(Cursor& cursor, QWidget* parent = nullptr);

  void follow(Workbench& workbench) override;
  /// The cursor's run and its setup; null: none.
  void set_run(std::shared_ptr<const ShownRun> shown, const SetupState& setup);

  /// Null for none.
  const std::shared_ptr<const ShownRun>& shown() const { return shown_; }

  /// Whether the panel is visible when shown: not while another one covers it.
  void set_on_screen(bool on_screen) override;
  bool is_seen() const { return on_screen_ && isVisible(); }

  /// Tries changes that may help at the cursor.
  void try_remedies();
  bool busy() const override { return job_.busy(); }

  /// Commands for the causes before and after, the slower place ahead, trying changes, and a run with a
  /// change.
  QList<QAction*> panel_actions() const override { return actions_; }
  RemedyTable& remedies() { return *table_model_; }
  QTableView* table() { return table_; }
  /// The shown text as plain text.
  QString cause_text() const;
  QString sentence_text() const;
  /// Effect of the drives here; empty if they make little of the contour error.
  QString drives_text() const;
  QString formula_text() const;

 signals:
  /// The user has chosen a place [s].
  void time_chosen(double time);
  /// Requests a new run with this setup.
  void run_wanted(const feedscope::ui::SetupState& setup);

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// Shortens the buttons to fit the panel; their tooltips have the full text.
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
  QTimer rest_;  ///< until the cursor is considered at rest

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
