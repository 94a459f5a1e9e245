#include "ui/shared/flow_layout.h"

#include <QWidget>
#include <algorithm>

namespace feedscope::ui {

FlowLayout::~FlowLayout() {
  qDeleteAll(items_);
}

QLayoutItem* FlowLayout::takeAt(int index) {
  return index >= 0 && index < count() ? items_.takeAt(index) : nullptr;
}

void FlowLayout::setGeometry(const QRect& area) {
  QLayout::setGeometry(area);
  place(area, true);
}

/// Size with all widgets in one row.
QSize FlowLayout::sizeHint() const {
  QSize size(0, 0);
  for (const QLayoutItem* item : items_) {
    const QSize one = item->sizeHint();
    size = {size.width() + (size.isEmpty() ? 0 : spacing()) + one.width(),
            std::max(size.height(), one.height())};
  }
  return size.grownBy(contentsMargins());
}

/// Size with the widgets one below the other.
QSize FlowLayout::minimumSize() const {
  QSize size(0, 0);
  for (const QLayoutItem* item : items_) {
    size = size.expandedTo(item->minimumSize());
  }
  return size.grownBy(contentsMargins());
}

int FlowLayout::place(const QRect& area, bool move) const {
  const QMargins margins = contentsMargins();
  const QRect inside = area.marginsRemoved(margins);
  int x = inside.x();
  int y = inside.y();
  int row = 0;
  for (QLayoutItem* item : items_) {
    if (item->isEmpty()) {
      continue;
    }
    const QSize size = item->sizeHint().boundedTo(
        {std::max(inside.width(), item->minimumSize().width()), item->sizeHint().height()});
    if (x > inside.x() && x + size.width() > inside.x() + inside.width()) {
      x = inside.x();
      y += row + spacing();
      row = 0;
    }
    if (move) {
      item->setGeometry({QPoint(x, y), size});
    }
    x += size.width() + spacing();
    row = std::max(row, size.height());
  }
  return y + row - area.y() + margins.bottom();
}

}  // namespace feedscope::ui
