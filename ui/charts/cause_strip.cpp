#include "ui/charts/cause_strip.h"

#include <QFontMetrics>
#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <numeric>
#include <utility>

#include "ui/charts/plot_margins.h"
#include "ui/language/core_texts.h"
#include "ui/theme/cause_colours.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

namespace {

int strip_height() {
  return type_pixels(10);
}
int swatch_side() {
  return type_pixels(9);
}
int swatch_gap() {
  return type_pixels(4);
}
int item_gap() {
  return type_pixels(14);
}
constexpr double min_named_share = 0.0005;  // of the visible time; smaller shares would read 0.0 %

QString percent(double share) {
  const double value = 100 * share;
  return CauseStrip::tr("%1 %").arg(QLocale().toString(value, 'f', value < 9.95 ? 1 : 0));
}

}  // namespace

QString cause_kind_name(CauseKind kind) {
  return shown_cause({kind, -1});
}

QString cause_name(Cause cause) {
  return shown_cause(cause);
}

CauseStrip::CauseStrip(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  set_type_pixels(*this, 11);
  setMouseTracking(true);
}

QSize CauseStrip::sizeHint() const {
  return {700, QFontMetrics(font()).height() + 4 + strip_height()};
}

QRect CauseStrip::strip() const {
  return {plot_left_margin(), height() - strip_height(), width() - plot_left_margin() - plot_right_margin,
          strip_height()};
}

void CauseStrip::set_causes(std::vector<std::optional<CauseKind>> columns, std::vector<double> times) {
  columns_ = std::move(columns);
  times_ = std::move(times);
  whole_ = std::accumulate(times_.begin(), times_.end(), 0.0);
  shares_.clear();
  for (std::size_t i = 0; i < times_.size(); ++i) {
    const CauseKind kind = all_causes()[i].kind;
    if (shares_.empty() || shares_.back().kind != kind) {
      shares_.push_back({kind, 0, {}, {}});
    }
    shares_.back().time += times_[i];
  }
  std::erase_if(shares_, [&](const Share& share) { return share.time <= min_named_share * whole_; });
  std::ranges::stable_sort(shares_, std::greater(), &Share::time);
  for (Share& share : shares_) {
    share.text = tr("%1 %2").arg(cause_kind_name(share.kind), percent(share.time / whole_));
  }
  lay_out();
  update();
}

void CauseStrip::name_run(const QString& name) {
  run_name_ = name;
  lay_out();
  update();
}

QString CauseStrip::title() const {
  return run_name_.isEmpty() ? tr("Limited by") : tr("%1 limited by", "run").arg(run_name_);
}

void CauseStrip::lay_out() {
  const QFontMetrics metrics(font());
  QFont bold = font();
  bold.setBold(true);
  const int more = metrics.horizontalAdvance(tr("+ %1").arg(99));
  const int row = height() - strip_height();
  int x = type_pixels(8) + QFontMetrics(bold).horizontalAdvance(title()) + item_gap();
  listed_ = 0;
  for (Share& share : shares_) {
    const int end = x + swatch_side() + swatch_gap() + metrics.horizontalAdvance(share.text);
    const bool last = listed_ + 1 == shares_.size();
    if (end + (last ? 0 : item_gap() + more) > width() - plot_right_margin) {
      break;
    }
    share.place = QRect(x, 0, end - x, row);
    x = end + item_gap();
    ++listed_;
  }
}

QRect CauseStrip::legend_item(CauseKind kind) const {
  for (std::size_t i = 0; i < listed_; ++i) {
    if (shares_[i].kind == kind) {
      return shares_[i].place;
    }
  }
  return {};
}

const CauseStrip::Share* CauseStrip::item_at(const QPoint& place) const {
  for (std::size_t i = 0; i < listed_; ++i) {
    if (shares_[i].place.contains(place)) {
      return &shares_[i];
    }
  }
  return nullptr;
}

std::optional<CauseKind> CauseStrip::kind_at(const QPoint& place) const {
  if (const Share* item = item_at(place)) {
    return item->kind;
  }
  const QRect bar = strip();
  if (!bar.contains(place) || columns_.empty()) {
    return {};
  }
  const auto column = static_cast<std::size_t>(place.x() - bar.left()) * columns_.size() /
                      static_cast<std::size_t>(bar.width());
  return columns_[column];
}

QString CauseStrip::tip_of(CauseKind kind) const {
  double time = 0;
  QStringList axes;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    const Cause cause = all_causes()[i];
    if (cause.kind == kind && times_[i] > 0) {
      time += times_[i];
      if (cause.axis >= 0) {
        axes += tr("%1: %2").arg(cause_name(cause), percent(times_[i] / whole_));
      }
    }
  }
  const QString whole = tr("%1: %2 of the visible time, %3 s")
                            .arg(cause_kind_name(kind), percent(whole_ > 0 ? time / whole_ : 0),
                                 QLocale().toString(time, 'f', 3));
  return axes.isEmpty() ? whole : whole + '\n' + axes.join('\n');
}

QString CauseStrip::tip_at(const QPoint& place) const {
  if (const auto kind = kind_at(place)) {
    return tip_of(*kind);
  }
  if (place.y() < strip().top()) {
    QStringList lines;
    for (const Share& share : shares_) {
      lines += share.text;
    }
    return lines.join('\n');
  }
  return {};
}

bool CauseStrip::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), tip_at(help->pos()), this);
    return true;
  }
  return QWidget::event(event);
}

void CauseStrip::mousePressEvent(QMouseEvent* event) {
  const Share* item = item_at(event->position().toPoint());
  if (event->button() == Qt::LeftButton) {
    const bool alone = item != nullptr && highlighted_ != item->kind;
    highlighted_ = alone ? std::optional(item->kind) : std::nullopt;
    update();
  }
}

void CauseStrip::mouseMoveEvent(QMouseEvent* event) {
  setCursor(item_at(event->position().toPoint()) != nullptr ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void CauseStrip::resizeEvent(QResizeEvent*) {
  lay_out();
}

void CauseStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  draw(painter);
}

void CauseStrip::draw(QPainter& painter) const {
  draw_legend(painter);
  draw_strip(painter);
}

void CauseStrip::draw_legend(QPainter& painter) const {
  const int row = height() - strip_height();
  const QColor text = palette().color(QPalette::WindowText);
  const QColor faint = palette().color(QPalette::Disabled, QPalette::WindowText);
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(text);
  painter.drawText(QRect(type_pixels(8), 0, width(), row), Qt::AlignLeft | Qt::AlignVCenter, title());
  painter.setFont(font());
  int end = 0;
  for (std::size_t i = 0; i < listed_; ++i) {
    const Share& share = shares_[i];
    const bool shown = !highlighted_.has_value() || highlighted_ == share.kind;
    const QRect box(share.place.left(), (row - swatch_side()) / 2, swatch_side(), swatch_side());
    painter.fillRect(box, shown ? colour_of_cause(share.kind, theme_of(palette())) : faint);
    painter.setPen(theme_colours(palette()).frame);
    painter.drawRect(box.adjusted(0, 0, -1, -1));
    painter.setPen(shown ? text : faint);
    painter.drawText(share.place.adjusted(swatch_side() + swatch_gap(), 0, 4, 0),
                     Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, share.text);
    end = share.place.right() + item_gap();
  }
  if (listed_ < shares_.size()) {
    painter.setPen(faint);
    painter.drawText(QRect(end, 0, width() - end, row), Qt::AlignLeft | Qt::AlignVCenter,
                     tr("+ %1").arg(shares_.size() - listed_));
  }
}

void CauseStrip::draw_strip(QPainter& painter) const {
  const QRect bar = strip();
  const ThemeColours& colours = theme_colours(palette());
  painter.fillRect(QRect(0, bar.top(), width(), bar.height()), colours.plot);
  const ThemeKind theme = theme_of(palette());
  const double column = static_cast<double>(bar.width()) / static_cast<double>(columns_.size());
  const auto is_drawn = [this](std::size_t i) {
    return i < columns_.size() && columns_[i].has_value() &&
           (!highlighted_.has_value() || highlighted_ == columns_[i]);
  };
  for (std::size_t i = 0; i < columns_.size();) {
    std::size_t end = i + 1;
    while (end < columns_.size() && columns_[end] == columns_[i]) {
      ++end;
    }
    if (is_drawn(i)) {  // overlaps the next one: PDF viewers show the background between edges
      const double left = bar.left() + static_cast<double>(i) * column;
      const double right = bar.left() + (static_cast<double>(end) + (is_drawn(end) ? 0.5 : 0)) * column;
      painter.fillRect(QRectF(left, bar.top() + 1, right - left, bar.height() - 2),
                       colour_of_cause(*columns_[i], theme));
    }
    i = end;
  }
  painter.setPen(colours.frame);
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(bar.adjusted(0, 0, -1, -1));
}

}  // namespace feedscope::ui
