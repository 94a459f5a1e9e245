#pragma once

#include <QTimer>

#include "ui/lessons/lesson_desk.h"
#include "ui/workbench/panel.h"

class QAction;
class QLabel;
class QPlainTextEdit;
class QPushButton;
class QScrollArea;
class QSplitter;
class QStackedWidget;
class QTextBrowser;
class QToolButton;

namespace feedscope::ui {

class NumberBox;
class TriesTable;

/// The list of lessons, or the open lesson: its text, its questions one by one with their control, the
/// measurement on the current run, the tried values and the user's answer; hint and expected answer on
/// request. While the lesson awaits a prediction, its input field replaces the questions.
class LessonView : public Panel {
  Q_OBJECT

 public:
  /// `desk` outlives this.
  explicit LessonView(LessonDesk& desk, QWidget* parent = nullptr);

  LessonDesk& desk() { return desk_; }
  /// All lessons as links.
  QTextBrowser& list() { return *list_; }
  /// Whether the list is shown, not the open lesson.
  bool shows_list() const;
  QTextBrowser& text() { return *text_; }
  QTextBrowser& question() { return *question_; }
  QPushButton& set_up_button() { return *set_up_; }
  QPushButton& answer_button() { return *answer_; }
  /// Buttons with the values of the control, in order.
  QList<QToolButton*> values() const;
  /// Field for other values of a numeric control.
  NumberBox& own_value() { return *own_value_; }
  TriesTable& tries() { return *tries_; }
  QPlainTextEdit& own_answer() { return *own_answer_; }
  QPlainTextEdit& own_prediction() { return *own_prediction_; }
  /// What is to be predicted, above the field for it.
  QTextBrowser& predict_text() { return *predict_text_; }
  /// The sentence about the learner's own control, to be completed after the last question.
  QPlainTextEdit& transfer() { return *transfer_; }
  /// Stores the prediction and shows the run.
  QPushButton& predict_button() { return *predict_; }
  /// The next or the previous step of the lesson before a class: the run without a prediction, then each
  /// question and its answer, then the sentence; a text that goes on below is read to its end first.
  void step(bool forward);
  /// Before a class one thing is shown at a time: the text, the prediction, or a question.
  void set_presenting(bool on);
  /// The lesson's answer, while it is shown.
  QTextBrowser& expected() { return *expected_; }
  QString measured() const;
  /// Whether the contents that a lesson replaced in the window can be restored.
  void offer_return(bool there);
  /// Set up the window, previous and next question, hint, answer, list of lessons, tries as text and as CSV,
  /// clear tries, restore the window.
  QList<QAction*> panel_actions() const override { return actions_; }
  /// Switches whether lessons show their run without a prediction.
  QAction* unlock_action() const { return unlock_action_; }

 signals:
  /// Requests to restore the window's contents before the lesson.
  void return_wanted();
  /// Requests to show the setting where it is edited.
  void setting_wanted(const QString& key);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_actions();
  void make_own_value();
  void lay_out();
  void share_height();
  /// Shows the text, the question below it, or both.
  void fold();
  QWidget* make_upper();
  QWidget* make_lower();
  QWidget* make_prediction();
  QWidget* make_transfer();
  /// To the next question or the previous one; the sentence to complete comes after the last.
  void go(bool forward);
  void read_text(bool on);
  bool shows_text_alone() const { return presenting_ && reading_; }
  int height_for_lower() const;
  void show_list();
  void show_lesson();
  void show_text();
  void show_cover();
  void show_question();
  void show_texts();
  void show_expected();
  void show_control();
  void show_value();
  void show_work();
  void try_own_value();
  void copy_csv() const;

  LessonDesk& desk_;
  QStackedWidget* pages_;
  QTextBrowser* list_;
  QTextBrowser* text_;
  QPushButton* set_up_;
  QPushButton* return_;
  QPushButton* next_;
  QLabel* number_;
  QToolButton* before_;
  QToolButton* after_;
  QTextBrowser* question_;
  QWidget* control_;
  QLabel* key_;
  QWidget* values_;
  QWidget* own_;
  NumberBox* own_value_;
  QToolButton* show_setting_;
  QLabel* value_;
  QStackedWidget* lower_;  ///< input field of the prediction, or question
  QTextBrowser* predict_text_;
  QPlainTextEdit* own_prediction_;
  QPushButton* predict_;
  QPlainTextEdit* transfer_;
  QWidget* transfer_page_ = nullptr;
  bool at_transfer_ = false;  ///< after the last question
  bool presenting_ = false;
  bool reading_ = true;  ///< while presenting_, the text is shown
  QWidget* tried_;
  TriesTable* tries_;
  QPlainTextEdit* own_answer_;
  QPushButton* hint_;
  QPushButton* answer_;
  QTextBrowser* expected_;
  QScrollArea* work_;  ///< contains all of a question
  QSplitter* halves_;  ///< the text above the question
  QTimer sharing_;     ///< delays share_height() until both are laid out
  bool shared_by_user_ = false;
  QList<QAction*> actions_;
  QAction* set_up_action_ = nullptr;
  QString measured_;
  QAction* return_action_ = nullptr;
  QAction* before_action_ = nullptr;
  QAction* after_action_ = nullptr;
  QAction* hint_action_ = nullptr;
  QAction* answer_action_ = nullptr;
  QAction* list_action_ = nullptr;
  QAction* copy_action_ = nullptr;
  QAction* csv_action_ = nullptr;
  QAction* clear_action_ = nullptr;
  QAction* unlock_action_ = nullptr;
};

}  // namespace feedscope::ui
