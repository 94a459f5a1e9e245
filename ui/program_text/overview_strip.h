#pragma once

#include <QWidget>
#include <cstdint>

namespace feedscope::ui {

class ProgramView;

/// Overview of the program in a ProgramView, from top to bottom: in every row of pixels the time of its lines
/// as a bar and as heat, the diagnostics and the current line; a frame around the visible lines. Press or
/// drag to go there.
class OverviewStrip : public QWidget {
  Q_OBJECT

 public:
  explicit OverviewStrip(ProgramView* view);

  QSize sizeHint() const override;

  struct Lines {
    std::uint32_t first = 0;  ///< 1-based; 0: none
    std::uint32_t last = 0;
  };
  /// The lines of a row of pixels.
  Lines lines_of(int y) const;

 signals:
  void line_pressed(std::uint32_t line);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  std::int64_t used_height() const;
  double top_of(std::uint32_t line) const;
  void paint_times(QPainter& painter) const;
  void paint_marks(QPainter& painter) const;
  void press(const QPointF& point);
  QString tip_at(int y) const;

  ProgramView& view_;
};

}  // namespace feedscope::ui
