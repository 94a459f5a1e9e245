#pragma once

#include <QWidget>

namespace feedscope::ui {

class ProgramView;

/// Margin of a ProgramView: diagnostics, line numbers and the heat of each line, hatched where the cycle time
/// omits an action. A press goes to the line.
class ProgramMargin : public QWidget {
  Q_OBJECT

 public:
  explicit ProgramMargin(ProgramView* view);

  QSize sizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void paint_line(QPainter& painter, std::uint32_t line) const;
  QString tip_of(std::uint32_t line) const;

  ProgramView& view_;
};

}  // namespace feedscope::ui
