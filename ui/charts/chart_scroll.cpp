#include "ui/charts/chart_scroll.h"

#include <QEvent>

namespace feedscope::ui {

ChartScroll::ChartScroll(const ChartRows& rows, QWidget* parent) : QScrollArea(parent), rows_(rows) {
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);
  setWidget(new QWidget(this));
}

bool ChartScroll::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) {
    updateGeometry();
  }
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace feedscope::ui
