#include "ui/window/panels/panel_scroll.h"

#include <QEvent>
#include <algorithm>

#include "ui/theme/type_size.h"

namespace feedscope::ui {

PanelScroll::PanelScroll(ui::Panel& panel, QWidget* parent) : QScrollArea(parent), panel_(panel) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  setWidget(&panel);
}

QSize PanelScroll::minimumSizeHint() const {
  // [px at the usual font size]
  constexpr QSize enough(260, 170);
  constexpr QSize for_others(520, 270);
  constexpr double share = 0.8;  // of the height left by the others
  const QSize window = this->window()->size();
  const int width = std::max(type_pixels(enough.width()), window.width() - type_pixels(for_others.width()));
  const int height = std::max(type_pixels(enough.height()),
                              static_cast<int>(share * (window.height() - type_pixels(for_others.height()))));
  return panel_.minimumSizeHint().boundedTo({width, height});
}

void PanelScroll::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  updateGeometry();
  fit();
}

bool PanelScroll::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &panel_ && event->type() == QEvent::LayoutRequest) {
    updateGeometry();
    fit();
  }
  return QScrollArea::eventFilter(watched, event);
}

void PanelScroll::fit() {
  panel_.resize(panel_.minimumSizeHint().expandedTo(viewport()->size()));
}

}  // namespace feedscope::ui
