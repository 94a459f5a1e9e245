#pragma once

#include <QTableWidget>

#include "core/lessons/lesson.h"
#include "ui/lessons/lesson_work.h"

namespace feedscope::ui {

/// A value of a question's control as the window shows it: a number with its decimal sign, a choice in its
/// language.
QString control_value_text(const std::string& value);

/// The values tried at a question, a row each: what the run measures with it, and the change against the
/// first one. As high as its rows.
class TriesTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit TriesTable(QWidget* parent = nullptr);

  /// `watched`: what the question watches, for people.
  void show_work(const Question& question, const QString& watched, const QuestionWork& work);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// All columns whole where there is room, the values shortened where not.
  void fit_columns();
  void fit_height();
};

}  // namespace feedscope::ui
