#pragma once

#include <QTableWidget>

#include "core/lessons/lesson.h"
#include "ui/lessons/lesson_work.h"

namespace feedscope::ui {

/// A value of a question's control for display: a number with the locale's decimal sign, a choice in its
/// language.
QString control_value_text(const std::string& value);

/// The tried values of a question, one row each: the measured quantities, and their change against the first.
/// As high as its rows.
class TriesTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit TriesTable(QWidget* parent = nullptr);

  /// `watched`: title of the watched quantity.
  void show_work(const Question& question, const QString& watched, const QuestionWork& work);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// Shows all columns in full if there is room, else shortens the values.
  void fit_columns();
  void fit_height();
};

}  // namespace feedscope::ui
