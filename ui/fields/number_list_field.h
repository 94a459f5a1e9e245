#pragma once

#include <QLineEdit>
#include <vector>

namespace feedscope::ui {

/// The field for several numbers, separated by blanks or semicolons, each read by number_of().
class NumberListField : public QLineEdit {
  Q_OBJECT

 public:
  using QLineEdit::QLineEdit;

  void set_numbers(const std::vector<double>& numbers);
  /// The typed numbers; empty if one of them is invalid, or nothing is typed.
  std::vector<double> numbers() const;
  /// Reason why numbers() is empty, and what to type instead; empty if it is not.
  QString problem() const;

 private:
  QStringList parts() const;
};

}  // namespace feedscope::ui
