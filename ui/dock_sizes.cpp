#include "ui/dock_sizes.h"

#include <QResizeEvent>
#include <algorithm>

namespace feedscope::ui {

DockSizes::DockSizes(QMainWindow& window, int left, int right, int bottom)
    : QObject(&window),
      window_(window),
      sides_{Side{Qt::LeftDockWidgetArea, Qt::Horizontal, 0.22, left},
             Side{Qt::RightDockWidgetArea, Qt::Horizontal, 0.3, right},
             Side{Qt::BottomDockWidgetArea, Qt::Vertical, 0.49, bottom}} {
  window_.installEventFilter(this);
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
    dock->installEventFilter(this);
  }
  resized_.setSingleShot(true);
  resized_.setInterval(0);
  connect(&resized_, &QTimer::timeout, this, &DockSizes::apply);
}

bool DockSizes::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    if (watched == &window_) {
      following_ = true;
      resized_.start();
    } else if (!following_) {
      note(*static_cast<QDockWidget*>(watched));
    }
  }
  return QObject::eventFilter(watched, event);
}

void DockSizes::note(QDockWidget& dock) {
  for (Side& side : sides_) {
    if (!dock.isFloating() && dock.isVisible() && window_.dockWidgetArea(&dock) == side.area) {
      side.wanted = side.extent(dock);
    }
  }
}

QDockWidget* DockSizes::shown_on(const Side& side) const {
  const QList<QDockWidget*> docks = window_.findChildren<QDockWidget*>();
  const auto found = std::ranges::find_if(docks, [&](QDockWidget* dock) {
    return !dock->isFloating() && dock->isVisible() && !dock->visibleRegion().isEmpty() &&
           window_.dockWidgetArea(dock) == side.area;
  });
  return found == docks.end() ? nullptr : *found;
}

/// A layout may have been restored before the window was shown; what does not have its size only because the
/// window is small is to have it later.
void DockSizes::begin() {
  begun_ = true;
  for (Side& side : sides_) {
    const QDockWidget* dock = shown_on(side);
    if (dock != nullptr && side.wanted <= side.most(window_)) {
      side.wanted = side.extent(*dock);
    }
  }
}

void DockSizes::apply() {
  if (!window_.isVisible()) {
    following_ = false;
    return;
  }
  if (!begun_) {
    begin();
  }
  for (const Side& side : sides_) {
    if (QDockWidget* dock = shown_on(side)) {
      window_.resizeDocks({dock}, {std::min(side.wanted, side.most(window_))}, side.orientation);
    }
  }
  // The panels get their sizes with the next turn of the event loop.
  QTimer::singleShot(0, this, [this] { following_ = resized_.isActive(); });
}

}  // namespace feedscope::ui
