#pragma once

#include <QTimer>
#include <optional>

#include "ui/program_text/input_bar.h"
#include "ui/program_text/text_search.h"

class QLabel;
class QLineEdit;
class QToolButton;

namespace feedscope::ui {

class ProgramView;

/// Searches the text of a ProgramView. Typing shows the first hit after the caret; stepping to a hit moves
/// the run's cursor there. Wraps at both ends.
class FindBar : public InputBar {
  Q_OBJECT

 public:
  /// `view` outlives this.
  explicit FindBar(ProgramView& view, QWidget* parent = nullptr);

  /// Opens with the selected text, ready to be overwritten.
  void open();
  void step(bool forward);

  TextSearch& search() { return search_; }
  QLineEdit& input() { return *input_; }
  QToolButton& match_case() { return *match_case_; }
  QToolButton& whole_word() { return *whole_word_; }
  QToolButton& regular_expression() { return *regular_expression_; }
  /// "3 of 120", or an error in the query.
  QString status() const;

 public slots:
  void close_bar() override;

 protected:
  bool event(QEvent* event) override;
  void enter(Qt::KeyboardModifiers modifiers) override;

 private:
  QToolButton* add_button(const QString& text, const QString& tip, bool checkable);
  void look_for_input();
  void show_result();
  void say_status();

  ProgramView& view_;
  TextSearch search_;
  QLineEdit* input_;
  QToolButton* match_case_;
  QToolButton* whole_word_;
  QToolButton* regular_expression_;
  QToolButton* next_;
  QToolButton* previous_;
  QLabel* status_;
  QTimer typing_;
  TextPlace start_;                 ///< of the search while the user types
  bool reveal_ = false;             ///< whether to show the first hit once it is known
  std::optional<bool> step_later_;  ///< a step, forward or not, pending until the result
};

}  // namespace feedscope::ui
