#include "ui/charts/feed_shares.h"

#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/theme/theme.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {

namespace {

constexpr double bar_height = 4;  // [px]
constexpr int right_margin = 8;

}  // namespace

FeedShares::FeedShares(const KinematicChart& chart, QWidget* parent) : QWidget(parent), chart_(chart) {
  setAccessibleName(tr("Share of time at each feed"));
  setAttribute(Qt::WA_AlwaysShowToolTips);
  hide();
}

void FeedShares::set_feeds(std::vector<float> feeds) {
  feeds_ = std::move(feeds);
  update();
}

std::size_t FeedShares::bar_count() const {
  const double height = chart_.height_of(0) - chart_.plot().top();
  return static_cast<std::size_t>(std::max(1.0, std::floor(height / bar_height)));
}

double FeedShares::value_of(std::size_t bar) const {
  return std::max(0.0, chart_.values().upper) * static_cast<double>(bar) / static_cast<double>(bar_count());
}

std::vector<double> FeedShares::shares() const {
  std::vector<double> shares(feeds_.empty() ? 0 : bar_count());
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const auto below = [&](double value) {
      return std::ranges::lower_bound(feeds_, value, {},
                                      [&](float feed) { return chart_.spec().convert(double{feed}); }) -
             feeds_.begin();
    };
    const auto from = i == 0 ? 0 : below(value_of(i));
    const auto to = i + 1 == shares.size() ? std::ssize(feeds_) : below(value_of(i + 1));
    shares[i] = static_cast<double>(to - from) / static_cast<double>(feeds_.size());
  }
  return shares;
}

QString FeedShares::tip_at(int y) const {
  const std::vector<double> shares = this->shares();
  const double above = (chart_.height_of(0) - y) /
                       std::max(1.0, chart_.height_of(0) - chart_.height_of(value_of(bar_count())));
  if (shares.empty() || above < 0 || above >= 1) {
    return {};
  }
  const auto bar = static_cast<std::size_t>(above * static_cast<double>(shares.size()));
  const QLocale locale;
  const auto number = [&](double value) { return locale.toString(value, 'f', chart_.spec().decimals); };
  const QString share = locale.toString(100 * shares[bar], 'f', 1);
  return bar + 1 == shares.size()
             ? tr("%1 %2 and more: %3 % of the time shown")
                   .arg(number(value_of(bar)), chart_.spec().unit, share)
             : tr("%1 to %2 %3: %4 % of the time shown")
                   .arg(number(value_of(bar)), number(value_of(bar + 1)), chart_.spec().unit, share);
}

void FeedShares::draw(QPainter& painter) const {
  const ThemeColours& colours = theme_colours(palette());
  painter.fillRect(rect(), colours.plot);
  const std::vector<double> shares = this->shares();
  if (shares.empty()) {
    return;
  }
  const double most = *std::ranges::max_element(shares);
  const double zero = chart_.height_of(0);
  const double step = (zero - chart_.height_of(value_of(shares.size()))) / static_cast<double>(shares.size());
  const double room = width() - right_margin;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double length = most > 0 ? room * shares[i] / most : 0;
    painter.fillRect(QRectF(0, zero - step * static_cast<double>(i + 1) + 0.5, length, step - 1),
                     colours.path);
  }
  painter.setPen(colours.frame);
  painter.drawLine(QPointF(0.5, chart_.plot().top()), QPointF(0.5, chart_.plot().bottom()));
  QFont small = font();
  small.setPixelSize(type_pixels(10));
  painter.setFont(small);
  painter.setPen(colours.text);
  const QRectF below(4, zero + 2, width() - 4, height() - zero - 2);
  const QString text = tr("time by feed\nmost: %1 %").arg(QLocale().toString(100 * most, 'f', 0));
  constexpr int flags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
  const QString title = text.section('\n', 0, 0);
  for (const QString& words : {text, title}) {  // the longest text that fits; tooltips have the whole
    if (QFontMetricsF(small).boundingRect(below, flags, words).height() <= below.height()) {
      painter.drawText(below, flags, words);
      break;
    }
  }
}

bool FeedShares::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), tip_at(help->pos().y()), this);
    return true;
  }
  return QWidget::event(event);
}

void FeedShares::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  draw(painter);
}

}  // namespace feedscope::ui
