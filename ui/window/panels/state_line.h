#pragma once

#include <QLabel>

namespace feedscope::ui {

/// Activity or result of a dialog, or an error, as text that can be selected.
class StateLine : public QLabel {
  Q_OBJECT

 public:
  explicit StateLine(QWidget* parent = nullptr);
  void say(const QString& message);
  /// Shows an error in its colour.
  void say_failure(const QString& message);
};

}  // namespace feedscope::ui
