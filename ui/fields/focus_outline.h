#pragma once

#include <QWidget>

namespace feedscope::ui {

/// A line around a widget that draws itself, visible while it has the keyboard focus.
class FocusOutline : public QWidget {
  Q_OBJECT

 public:
  /// Drawn over `target`, which owns it. If given, `beside`, the parent of `target`, owns it, and
  /// target.grab() does not include it.
  explicit FocusOutline(QWidget& target, QWidget* beside = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void follow();

  QWidget& target_;
};

}  // namespace feedscope::ui
