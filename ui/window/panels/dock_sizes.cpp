#include "ui/window/panels/dock_sizes.h"

#include <QGuiApplication>
#include <QResizeEvent>
#include <QTabBar>
#include <algorithm>

namespace feedscope::ui {

DockSizes::DockSizes(QMainWindow& window, int left, int right, int bottom)
    : QObject(&window),
      window_(window),
      sides_{Side{Qt::LeftDockWidgetArea, Qt::Horizontal, 0.25, 0.08, left},
             Side{Qt::RightDockWidgetArea, Qt::Horizontal, 0.3, 0.33, right, 0.094},
             Side{Qt::BottomDockWidgetArea, Qt::Vertical, 0.49, 0.49, bottom, 0.5}} {
  window_.installEventFilter(this);
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
    dock->installEventFilter(this);
  }
  resized_.setSingleShot(true);
  resized_.setInterval(0);
  connect(&resized_, &QTimer::timeout, this, &DockSizes::apply);
}

bool DockSizes::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && !paused_) {
    if (watched == &window_) {
      following_ = true;
      resized_.start();
    } else if (!following_ && QGuiApplication::mouseButtons() != Qt::NoButton) {
      note(*static_cast<QDockWidget*>(watched));
    }
  }
  return QObject::eventFilter(watched, event);
}

void DockSizes::note(QDockWidget& dock) {
  for (Side& side : sides_) {
    if (!dock.isFloating() && dock.isVisible() && window_.dockWidgetArea(&dock) == side.area) {
      adopt(side, dock);
      side.sized = true;
    }
  }
}

/// Height of the tabs above a dock, which are not part of it, but of the sizes in QMainWindow::resizeDocks().
int DockSizes::tab_height(const QDockWidget& dock) const {
  const auto bars = window_.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly);
  const auto above = std::ranges::find_if(bars, [&](const QTabBar* bar) {
    const int gap = dock.y() - bar->geometry().bottom();
    return bar->isVisible() && gap >= 0 && gap < bar->height() &&
           bar->geometry().left() <= dock.geometry().right() &&
           bar->geometry().right() >= dock.geometry().left();
  });
  return above == bars.end() ? 0 : (*above)->height();
}

void DockSizes::adopt(Side& side, const QDockWidget& dock) const {
  side.wanted = side.extent(dock) + (side.orientation == Qt::Vertical ? tab_height(dock) : 0);
  side.largest_share =
      std::max(side.usual_share, static_cast<double>(side.wanted + 1) / side.extent(window_));
}

QDockWidget* DockSizes::shown_on(const Side& side) const {
  // The last of those that share a place as tabs is in front; the start page may cover them all.
  QDockWidget* front = nullptr;
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) {
    if (!dock->isFloating() && dock->isVisible() && window_.dockWidgetArea(dock) == side.area) {
      front = dock;
    }
  }
  return front;
}

void DockSizes::follow_layout() {
  begun_ = false;
  restored_ = true;
  following_ = true;
  resized_.start();
}

void DockSizes::follow_first_layout() {
  for (Side& side : sides_) {
    side.wanted = side.first;
    side.sized = false;
    side.largest_share = side.usual_share;
  }
  following_ = true;
  resized_.start();
}

/// A layout may have been restored before the window was shown; panels reduced only because the window is
/// small shall regain their size.
void DockSizes::begin() {
  begun_ = true;
  for (Side& side : sides_) {
    const QDockWidget* dock = shown_on(side);
    if (dock != nullptr && (restored_ || side.wanted <= side.most(window_))) {
      adopt(side, *dock);
    }
    side.sized = restored_;
  }
}

void DockSizes::apply() {
  if (paused_ || !window_.isVisible()) {
    following_ = false;
    return;
  }
  if (!begun_) {
    begin();
  }
  for (const Side& side : sides_) {
    if (QDockWidget* dock = shown_on(side)) {
      window_.resizeDocks({dock}, {std::min(side.aim(window_), side.most(window_))}, side.orientation);
    }
  }
  // The panels get their sizes in the next turn of the event loop.
  QTimer::singleShot(0, this, [this] { following_ = resized_.isActive(); });
}

}  // namespace feedscope::ui
