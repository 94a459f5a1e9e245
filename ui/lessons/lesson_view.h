#pragma once

#include "ui/lessons/lesson_desk.h"
#include "ui/workbench/panel.h"

class QAction;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QTextBrowser;
class QToolButton;

namespace feedscope::ui {

/// A lesson beside the window that it is about: its text, its questions one by one with the control to move
/// and what the current run measures, hint and answer when asked for.
class LessonView : public Panel {
  Q_OBJECT

 public:
  /// `desk` outlives this.
  explicit LessonView(LessonDesk& desk, QWidget* parent = nullptr);

  LessonDesk& desk() { return desk_; }
  QComboBox& lessons() { return *lessons_; }
  QTextBrowser& text() { return *text_; }
  QTextBrowser& question() { return *question_; }
  QPushButton& set_up_button() { return *set_up_; }
  QPushButton& answer_button() { return *answer_; }
  /// Buttons with the values of the control, in their order.
  QList<QToolButton*> values() const;
  QString measured() const;
  /// Whether there is something to bring back that a lesson has replaced in the window.
  void offer_return(bool there);
  /// Set up the window, bring back what was in it, next and previous question, hint, answer.
  QList<QAction*> panel_actions() const override { return actions_; }

 signals:
  /// What was in the window before the lesson is to be brought back.
  void return_wanted();
  /// The setting is to be shown where it is edited.
  void setting_wanted(const QString& key);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void make_actions();
  void lay_out();
  void show_list();
  void show_contents();
  void show_lesson();
  void show_question();
  void show_texts();
  void show_control();
  void show_value();

  LessonDesk& desk_;
  QComboBox* lessons_;
  QTextBrowser* text_;
  QPushButton* set_up_;
  QPushButton* return_;
  QLabel* number_;
  QToolButton* before_;
  QToolButton* after_;
  QTextBrowser* question_;
  QWidget* control_;
  QLabel* key_;
  QWidget* values_;
  QToolButton* show_setting_;
  QLabel* value_;
  QPushButton* hint_;
  QPushButton* answer_;
  QList<QAction*> actions_;
  QAction* set_up_action_ = nullptr;
  QAction* return_action_ = nullptr;
  QAction* before_action_ = nullptr;
  QAction* after_action_ = nullptr;
  QAction* hint_action_ = nullptr;
  QAction* answer_action_ = nullptr;
};

}  // namespace feedscope::ui
