#pragma once

#include <QLineEdit>
#include <vector>

namespace feedscope::ui {

/// The field for several numbers: separated by blanks or semicolons, each typed as number_of() reads it.
class NumberListField : public QLineEdit {
  Q_OBJECT

 public:
  using QLineEdit::QLineEdit;

  void set_numbers(const std::vector<double>& numbers);
  /// Those that are typed; empty where one of them is none, or nothing is typed.
  std::vector<double> numbers() const;
  /// Why numbers() is empty and what to type instead; empty if it is not.
  QString problem() const;

 private:
  QStringList parts() const;
};

}  // namespace feedscope::ui
