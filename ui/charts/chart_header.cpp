#include "ui/charts/chart_header.h"

#include <QFontMetrics>
#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <cmath>

#include "ui/charts/plot_margins.h"

namespace feedscope::ui {

namespace {

constexpr int left = 8;
constexpr int swatch_width = 18;
constexpr int gap = 5;
constexpr int curve_gap = 16;
constexpr int longest_run_name = 160;  // [px]

QFont bold(QFont font) {
  font.setBold(true);
  return font;
}

}  // namespace

ChartHeader::ChartHeader(ChartSpec spec, QWidget* parent)
    : QWidget(parent), spec_(std::move(spec)), shown_(spec_.curves.size(), true) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  QFont small = font();
  small.setPixelSize(11);
  setFont(small);
  setMouseTracking(true);
}

void ChartHeader::set_state(const std::optional<State>& state) {
  state_ = state;
  update();
}

void ChartHeader::show_curve(std::size_t curve, bool shown) {
  shown_[curve] = shown;
  update();
}

void ChartHeader::set_runs(std::vector<LegendEntry> runs) {
  const bool resized = runs.empty() != runs_.empty();
  runs_ = std::move(runs);
  if (resized) {
    updateGeometry();
  }
  update();
}

int ChartHeader::row_height() const {
  return QFontMetrics(font()).height() + 4;
}

int ChartHeader::value_width() const {
  return QFontMetrics(font()).horizontalAdvance(QStringLiteral("-00000.0"));
}

QString ChartHeader::unit_text() const {
  return QStringLiteral("[%1]").arg(spec_.unit);
}

QString ChartHeader::number(double value) const {
  const bool none = std::abs(value) < std::pow(10, -spec_.decimals) / 2;  // no minus before zero
  return QLocale().toString(none ? 0 : value, 'f', spec_.decimals);
}

QSize ChartHeader::sizeHint() const {
  return {700, runs_.empty() ? row_height() : 2 * row_height()};
}

QRect ChartHeader::item(std::size_t curve) const {
  const QFontMetrics metrics(font());
  int x = left + QFontMetrics(bold(font())).horizontalAdvance(spec_.title) + gap +
          metrics.horizontalAdvance(unit_text()) + curve_gap;
  for (std::size_t i = 0;; ++i) {
    const int width = swatch_width + gap + metrics.horizontalAdvance(spec_.curves[i].name) + value_width();
    if (i == curve) {
      return {x, 0, width, row_height()};
    }
    x += width + curve_gap;
  }
}

std::optional<std::size_t> ChartHeader::curve_at(const QPoint& place) const {
  for (std::size_t i = 0; i < spec_.curves.size(); ++i) {
    if (item(i).contains(place)) {
      return i;
    }
  }
  return {};
}

bool ChartHeader::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) {
    return QWidget::event(event);
  }
  const auto* help = static_cast<QHelpEvent*>(event);
  QString tip;
  if (const auto curve = curve_at(help->pos())) {
    tip = tr("%1, %2 [%3]\nClick: hide or show. Ctrl+click: only this one.")
              .arg(spec_.title, spec_.curves[*curve].name, spec_.unit);
  }
  QToolTip::showText(help->globalPos(), tip, this);
  return true;
}

void ChartHeader::mousePressEvent(QMouseEvent* event) {
  const auto curve = curve_at(event->position().toPoint());
  if (event->button() != Qt::LeftButton || !curve) {
    return;
  }
  if (event->modifiers().testFlag(Qt::ControlModifier)) {
    emit curve_alone_clicked(*curve);
  } else {
    emit curve_clicked(*curve);
  }
}

void ChartHeader::mouseMoveEvent(QMouseEvent* event) {
  setCursor(curve_at(event->position().toPoint()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void ChartHeader::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  draw(painter);
}

void ChartHeader::draw(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  draw_title(painter);
  for (std::size_t i = 0; i < spec_.curves.size(); ++i) {
    draw_curve(painter, i);
  }
  draw_runs(painter);
}

void ChartHeader::draw_title(QPainter& painter) const {
  painter.setPen(palette().color(QPalette::WindowText));
  painter.setFont(bold(font()));
  const int title = QFontMetrics(painter.font()).horizontalAdvance(spec_.title);
  painter.drawText(QRect(left, 0, title + gap, row_height()), Qt::AlignVCenter, spec_.title);
  painter.setFont(font());
  painter.drawText(QRect(left + title + gap, 0, width(), row_height()), Qt::AlignVCenter, unit_text());
}

void ChartHeader::draw_curve(QPainter& painter, std::size_t curve) const {
  const CurveSpec& spec = spec_.curves[curve];
  const QRect place = item(curve);
  const bool shown = shown_[curve];
  const QColor faint = palette().color(QPalette::Disabled, QPalette::WindowText);
  const QColor color = shown ? curve_colour(spec.role, theme_colours(palette())) : faint;
  const int middle = place.center().y();
  painter.setPen(QPen(color, shown ? spec.width + 1 : 1));
  painter.drawLine(place.left(), middle, place.left() + swatch_width, middle);
  painter.setPen(shown ? palette().color(QPalette::WindowText) : faint);
  const QRect words = place.adjusted(swatch_width + gap, 0, 0, 0);
  painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, spec.name);
  if (state_.has_value() && shown) {
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter,
                     number(spec_.convert(channel_value(*state_, spec.channel))));
  }
}

void ChartHeader::draw_runs(QPainter& painter) const {
  const QFontMetrics metrics(font());
  const int top = row_height();
  int x = plot_left_margin;
  for (const LegendEntry& run : runs_) {
    const QString name = metrics.elidedText(run.name, Qt::ElideMiddle, longest_run_name);
    const int room = metrics.horizontalAdvance(name) + (run.value ? value_width() : 0);
    const QRect words(x + swatch_width + gap, top, room + 1, row_height());
    if (words.right() > width()) {
      return;
    }
    painter.setPen(QPen(run.color, 2, run.dashed ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(x, words.center().y(), x + swatch_width, words.center().y());
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, name);
    if (run.value.has_value()) {
      painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, number(*run.value));
    }
    x = words.right() + curve_gap;
  }
}

}  // namespace feedscope::ui
