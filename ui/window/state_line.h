#pragma once

#include <QLabel>

namespace feedscope::ui {

/// What a dialog does or has done, or what went wrong, as text that can be selected.
class StateLine : public QLabel {
  Q_OBJECT

 public:
  explicit StateLine(QWidget* parent = nullptr);
  void say(const QString& message);
  /// In the colour of what is wrong.
  void say_failure(const QString& message);
};

}  // namespace feedscope::ui
