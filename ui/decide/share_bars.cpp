#include "ui/decide/share_bars.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "ui/theme/theme.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {

ShareBars::ShareBars(QWidget* parent) : QWidget(parent) {
  set_type_pixels(*this, 12);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ShareBars::set(std::vector<ShareBarRow> rows) {
  rows_ = std::move(rows);
  updateGeometry();
  update();
}

int ShareBars::row_height() const {
  return QFontMetrics(font()).height() + 5;
}

QSize ShareBars::sizeHint() const {
  return {type_pixels(260), row_height() * static_cast<int>(rows_.size())};
}

QRectF ShareBars::row_place(std::size_t row) const {
  return {0, static_cast<double>(row) * row_height(), static_cast<double>(width()),
          static_cast<double>(row_height())};
}

std::size_t ShareBars::row_at(const QPointF& place) const {
  return static_cast<std::size_t>(std::max(0.0, place.y()) / row_height());
}

void ShareBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColours& colours = theme_colours(palette());
  const QFontMetrics metrics(font());
  int values = 0;
  for (const ShareBarRow& row : rows_) {
    values = std::max(values, metrics.horizontalAdvance(row.value));
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const ShareBarRow& row = rows_[i];
    const QRectF place = row_place(i);
    const QRectF bar = place.adjusted(0, 1, -values - 10, -2);
    constexpr float opacity = 0.35F;
    QColor pale = row.colour;
    pale.setAlphaF(opacity);
    painter.fillRect(QRectF(bar.left(), bar.top(), std::max(2.0, row.share * bar.width()), bar.height()),
                     pale);
    painter.setPen(colours.text);
    painter.drawText(bar.adjusted(4, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(row.text, Qt::ElideRight, static_cast<int>(bar.width()) - 4));
    painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, row.value);
  }
}

void ShareBars::mousePressEvent(QMouseEvent* event) {
  if (const std::size_t row = row_at(event->position()); row < rows_.size()) {
    emit clicked(row);
  }
}

bool ShareBars::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) {
    return QWidget::event(event);
  }
  const auto* help = static_cast<QHelpEvent*>(event);
  if (const std::size_t row = row_at(help->pos()); row < rows_.size()) {
    QToolTip::showText(help->globalPos(), rows_[row].text + QLatin1Char('\n') + rows_[row].tip, this);
  }
  return true;
}

}  // namespace feedscope::ui
