#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>
#include <QWheelEvent>
#include <memory>

#include "tests/ui/run_fixture.h"
#include "ui/charts/charts_panel.h"

namespace feedscope::ui::test {

using feedscope::test::simulate_text;
using feedscope::test::small_program;

/// The charts of a small program at the size that they have in the window.
class ChartsPanelTest : public testing::Test {
 protected:
  ChartsPanelTest() : panel(cursor, range) {
    panel.resize(940, 390);
    panel.show();
    cursor.set_trajectory(run.trajectory);
    panel.set_limits(run.setup);
    panel.set_run(run.trajectory, envelope, false);
    QApplication::processEvents();
    panel.refresh();
  }

  QRectF plot(std::size_t chart) { return panel.chart(chart).plot(); }
  QPoint place(std::size_t chart, double x, double y) {
    const QRectF area = plot(chart);
    return QPointF(area.left() + x * area.width(), area.top() + y * area.height()).toPoint();
  }
  void drag(std::size_t chart, QPoint from, QPoint to, Qt::MouseButton button,
            Qt::KeyboardModifiers modifiers = {}) {
    QWidget* view = &panel.chart(chart);
    QTest::mousePress(view, button, modifiers, from);
    for (const QPoint& at : {(from + to) / 2, to}) {
      QMouseEvent move(QEvent::MouseMove, QPointF(at), view->mapToGlobal(QPointF(at)), Qt::NoButton, button,
                       modifiers);
      QApplication::sendEvent(view, &move);
    }
    QTest::mouseRelease(view, button, modifiers, to);
    panel.refresh();
  }
  void wheel(std::size_t chart, QPoint at, Qt::KeyboardModifiers modifiers) {
    QWidget* view = &panel.chart(chart);
    QWheelEvent event(QPointF(at), view->mapToGlobal(QPointF(at)), {}, {0, 120}, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(view, &event);
    panel.refresh();
  }

  const Trajectory& trajectory() const { return *run.trajectory; }

  feedscope::Run run = simulate_text(small_program);
  std::shared_ptr<const Envelope> envelope = std::make_shared<const Envelope>(run.trajectory);
  Cursor cursor;
  ViewRange range;
  ChartsPanel panel;
};

}  // namespace feedscope::ui::test
