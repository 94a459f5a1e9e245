#include "ui/charts/chart_header.h"

#include <QFontMetrics>
#include <QLocale>
#include <QPainter>

namespace feedscope::ui {

namespace {

constexpr int swatch_width = 18;
constexpr int gap = 5;
constexpr int curve_gap = 16;

}  // namespace

ChartHeader::ChartHeader(ChartSpec spec, QWidget* parent) : QWidget(parent), spec_(std::move(spec)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  QFont small = font();
  small.setPixelSize(11);
  setFont(small);
}

void ChartHeader::set_state(const std::optional<State>& state) {
  state_ = state;
  update();
}

QSize ChartHeader::sizeHint() const {
  return {700, QFontMetrics(font()).height() + 4};
}

void ChartHeader::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont bold = font();
  bold.setBold(true);
  const QFontMetrics bold_metrics(bold);
  const QFontMetrics metrics(font());
  const auto text = [&](int x, int width, const QString& words, Qt::Alignment side = Qt::AlignLeft) {
    painter.drawText(QRect(x, 0, width, height()), side | Qt::AlignVCenter, words);
    return x + width + gap;
  };

  painter.setFont(bold);
  painter.setPen(palette().color(QPalette::WindowText));
  int x = text(8, bold_metrics.horizontalAdvance(spec_.title), spec_.title);
  painter.setFont(font());
  const QString unit = QStringLiteral("[%1]").arg(spec_.unit);
  x = text(x, metrics.horizontalAdvance(unit), unit) + curve_gap;

  const int value_width = metrics.horizontalAdvance(QStringLiteral("-00000.0"));
  for (const CurveSpec& curve : spec_.curves) {
    painter.setPen(QPen(curve.color, curve.width + 1));
    painter.drawLine(x, height() / 2, x + swatch_width, height() / 2);
    x += swatch_width + gap;
    painter.setPen(palette().color(QPalette::WindowText));
    x = text(x, metrics.horizontalAdvance(curve.name), curve.name);
    if (state_.has_value()) {
      const double value = spec_.convert(channel_value(*state_, curve.channel));
      const QString number = QLocale().toString(value, 'f', spec_.decimals);
      text(x - gap, value_width, number, Qt::AlignRight);
    }
    x += value_width + curve_gap;
  }
}

}  // namespace feedscope::ui
