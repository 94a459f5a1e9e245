#include "ui/charts/chart_scroll.h"

#include <QEvent>
#include <QLayout>
#include <QScrollBar>
#include <algorithm>

#include "ui/theme/type_size.h"

namespace feedscope::ui {

namespace {

/// The content, as low as its layout permits: a scroll area takes the height for a width as the least one. If
/// all fits without a scroll bar, the height is for the full width: a bar would make the headers longer and
/// never disappear.
class Content : public QWidget {
 public:
  explicit Content(const QScrollArea& area) : area_(area) {}
  int heightForWidth(int width) const override {
    const QSize room = area_.maximumViewportSize();
    const int least = layout()->minimumHeightForWidth(std::max(width, room.width()));
    return least <= room.height() ? least : layout()->minimumHeightForWidth(width);
  }

 private:
  const QScrollArea& area_;
};

}  // namespace

ChartScroll::ChartScroll(const ChartRows& rows, QWidget* parent) : QScrollArea(parent), rows_(rows) {
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);
  setWidget(new Content(*this));
}

/// Assumes a scroll bar, because whether one is needed may depend on this.
void ChartScroll::fit_shares() {
  rows_.give_shares_room(*widget()->layout(),
                         maximumViewportSize().width() - verticalScrollBar()->sizeHint().width());
}

void ChartScroll::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  constexpr int enough = 320;  // [px] height that the charts of the motion keep
  rows_.lost->set_room(height() >= type_pixels(enough));
  fit_shares();
}

bool ChartScroll::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) {
    updateGeometry();
  }
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace feedscope::ui
