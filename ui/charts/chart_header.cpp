#include "ui/charts/chart_header.h"

#include <QFontMetrics>
#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/theme/type_size.h"

namespace feedscope::ui {

namespace {

int inset() {
  return type_pixels(3);
}
int swatch_width() {
  return type_pixels(14);
}
int gap() {
  return type_pixels(7);
}

QFont bold(QFont font) {
  font.setBold(true);
  return font;
}

}  // namespace

ChartHeader::ChartHeader(ChartSpec spec, QWidget* parent)
    : QWidget(parent),
      spec_(std::move(spec)),
      shown_(spec_.curves.size(), true),
      available_(spec_.curves.size(), true) {
  std::transform(spec_.curves.begin(), spec_.curves.end(), shown_.begin(),
                 [](const CurveSpec& curve) { return !curve.on_demand; });
  std::transform(spec_.curves.begin(), spec_.curves.end(), available_.begin(),
                 [&](const CurveSpec& curve) { return info_of(curve.quantity).source == spec_.source; });
  set_type_pixels(*this, 11);
  setMouseTracking(true);
}

void ChartHeader::fit_in(const QRect& room) {
  room_ = room;
  relist();
}

void ChartHeader::relist() {
  setGeometry(room_.left(), room_.top(), std::min(sizeHint().width(), room_.width()), sizeHint().height());
  update();
}

void ChartHeader::show_values(const std::optional<Instant>& instant) {
  values_.assign(spec_.curves.size(), std::nullopt);
  for (std::size_t i = 0; instant && i < values_.size(); ++i) {
    const double value = info_of(spec_.curves[i].quantity).of(*instant);
    values_[i] = std::isnan(value) ? std::nullopt : std::optional(spec_.convert(value));
  }
}

void ChartHeader::show_curve(std::size_t curve, bool shown) {
  shown_[curve] = shown;
  relist();
}

void ChartHeader::set_available(std::vector<bool> available) {
  available_ = std::move(available);
  relist();
}

void ChartHeader::name_run(const QString& name) {
  run_name_ = name;
  relist();
}

void ChartHeader::set_runs(std::vector<LegendEntry> runs) {
  runs_ = std::move(runs);
  relist();
}

void ChartHeader::set_notes(std::vector<LimitLine> limits, QStringList notes) {
  limits_ = std::move(limits);
  notes_ = std::move(notes);
  relist();
}

void ChartHeader::list_all(bool all) {
  all_ = all;
  relist();
}

QString ChartHeader::number(double value) const {
  const bool none = std::abs(value) < std::pow(10, -spec_.decimals) / 2;  // no minus sign before zero
  return QLocale().toString(none ? 0 : value, 'f', spec_.decimals);
}

QString ChartHeader::title() const {
  return run_name_.isEmpty() ? spec_.title : tr("%1 of %2", "feed, run").arg(spec_.title, run_name_);
}

int ChartHeader::title_width() const {
  return inset() + QFontMetrics(bold(font())).horizontalAdvance(title()) + inset() +
         QFontMetrics(font()).horizontalAdvance(spec_.unit) + gap();
}

const QString& ChartHeader::text_of(Kind kind, std::size_t index) const {
  switch (kind) {
    case Kind::curve:
      return spec_.curves[index].name;
    case Kind::run:
      return runs_[index].name;
    case Kind::limit:
      return limits_[index].label;
    case Kind::note:
      break;
  }
  return notes_[static_cast<qsizetype>(index)];
}

int ChartHeader::width_of(Kind kind, std::size_t index) const {
  const bool has_line = kind == Kind::run || kind == Kind::limit;
  constexpr int spare = 2;  // a printed font may be wider
  return QFontMetrics(font()).horizontalAdvance(text_of(kind, index)) + spare +
         (has_line ? swatch_width() + inset() : 0);
}

std::vector<ChartHeader::Item> ChartHeader::items(int width) const {
  std::vector<Item> items;
  int x = title_width();
  const int height = sizeHint().height();
  const auto add = [&](Kind kind, std::size_t index) {
    const int wide = width_of(kind, index);
    if (x + wide <= width) {
      items.push_back({kind, index, QRect(x, 0, wide, height)});
      x += wide + gap();
    }
  };
  for (const bool shown : {true, false}) {
    for (std::size_t i = 0; i < spec_.curves.size() && (shown || all_); ++i) {
      if (available_[i] && shown_[i] == shown) {
        add(Kind::curve, i);
      }
    }
    for (std::size_t i = 0; i < runs_.size() && shown && all_; ++i) {
      add(Kind::run, i);
    }
  }
  for (std::size_t i = 0; i < limits_.size() && all_; ++i) {
    add(Kind::limit, i);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(notes_.size()) && all_; ++i) {
    add(Kind::note, i);
  }
  return items;
}

QSize ChartHeader::sizeHint() const {
  const int height = QFontMetrics(font()).height() + 1;
  const QFontMetrics metrics(font());
  int width = title_width();
  const auto add = [&](Kind kind, std::size_t count, auto counts) {
    for (std::size_t i = 0; i < count; ++i) {
      width += counts(i) ? width_of(kind, i) + gap() : 0;
    }
  };
  const auto listed = [this](std::size_t) { return all_; };
  add(Kind::curve, spec_.curves.size(), [&](std::size_t i) { return available_[i] && (shown_[i] || all_); });
  add(Kind::run, runs_.size(), listed);
  add(Kind::limit, limits_.size(), listed);
  add(Kind::note, static_cast<std::size_t>(notes_.size()), listed);
  return {width, height};
}

QRect ChartHeader::item(std::size_t curve) const {
  for (const Item& item : items(width())) {
    if (item.kind == Kind::curve && item.index == curve) {
      return item.place;
    }
  }
  return {};
}

std::optional<std::size_t> ChartHeader::curve_at(const QPoint& place) const {
  for (const Item& item : items(width())) {
    if (item.kind == Kind::curve && item.place.contains(place)) {
      return item.index;
    }
  }
  return std::nullopt;
}

QString ChartHeader::tip_at(const QPoint& place) const {
  if (const auto curve = curve_at(place)) {
    const QString text = tr("%1, %2 [%3]\nClick: hide or show. Ctrl+click: only this one.")
                             .arg(spec_.title, spec_.curves[*curve].name, spec_.unit);
    const bool valued = *curve < values_.size() && values_[*curve];
    return valued ? text + QLatin1Char('\n') + tr("At the cursor: %1").arg(number(*values_[*curve])) : text;
  }
  QStringList lines;
  for (const LegendEntry& run : runs_) {
    lines.append(run.value ? QStringLiteral("%1: %2").arg(run.name, number(*run.value)) : run.name);
  }
  for (const LimitLine& limit : limits_) {
    lines.append(QStringLiteral("%1: %2").arg(limit.label, number(limit.value)));
  }
  return (lines + notes_).join(QLatin1Char('\n'));
}

bool ChartHeader::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::Enter:
      list_all(true);
      break;
    case QEvent::Leave:
      list_all(false);
      break;
    case QEvent::FontChange:
      relist();
      break;
    case QEvent::ToolTip: {
      const auto* help = static_cast<QHelpEvent*>(event);
      QToolTip::showText(help->globalPos(), tip_at(help->pos()), this);
      return true;
    }
    default:
      break;
  }
  return QWidget::event(event);
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
  const ThemeColours& colours = theme_colours(palette());
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = colours.plot;
  constexpr int nearly_opaque = 215;
  ground.setAlpha(nearly_opaque);
  painter.fillRect(rect(), ground);
  painter.setPen(colours.text);
  painter.setFont(bold(font()));
  const int wide = QFontMetrics(painter.font()).horizontalAdvance(title());
  painter.drawText(QRect(inset(), 0, wide + inset(), height()), Qt::AlignVCenter, title());
  painter.setFont(font());
  painter.setPen(colours.muted);
  painter.drawText(QRect(2 * inset() + wide, 0, width(), height()), Qt::AlignVCenter, spec_.unit);
  for (const Item& item : items(width())) {
    draw_item(painter, item);
  }
}

void ChartHeader::draw_item(QPainter& painter, const Item& item) const {
  const ThemeColours& colours = theme_colours(palette());
  QRect place = item.place;
  QColor text = colours.text;
  if (item.kind == Kind::curve) {
    text = shown_[item.index] ? curve_colour(spec_.curves[item.index].role, colours)
                              : palette().color(QPalette::Disabled, QPalette::WindowText);
  } else if (item.kind != Kind::note) {
    const QPointF from(place.left(), place.center().y());
    const QPointF to = from + QPointF(swatch_width(), 0);
    if (item.kind == Kind::limit) {
      draw_limit_line(painter, from, to, limits_[item.index], colours, line_pixels(1, *this));
    } else {
      const LegendEntry& run = runs_[item.index];
      painter.setPen(
          QPen(run.color, line_pixels(2, *this), run.dashed ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap));
      painter.drawLine(from, to);
    }
    place.setLeft(place.left() + swatch_width() + inset());
  }
  painter.setPen(text);
  painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                   text_of(item.kind, item.index));
}

}  // namespace feedscope::ui
