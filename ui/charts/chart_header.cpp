#include "ui/charts/chart_header.h"

#include <QFontMetrics>
#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QResizeEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/charts/plot_margins.h"

namespace feedscope::ui {

namespace {

int left_inset() {
  return type_pixels(8);
}
int swatch_width() {
  return type_pixels(18);
}
int name_gap() {
  return type_pixels(5);
}
int curve_gap() {
  return type_pixels(10);
}
int longest_run_name() {
  return type_pixels(160);
}
constexpr int max_run_rows = 2;

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
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  set_type_pixels(*this, 11);
  setMouseTracking(true);
}

void ChartHeader::show_values(const std::optional<Instant>& instant) {
  values_.assign(spec_.curves.size(), std::nullopt);
  for (std::size_t i = 0; instant && i < values_.size(); ++i) {
    const double value = info_of(spec_.curves[i].quantity).of(*instant);
    values_[i] = std::isnan(value) ? std::nullopt : std::optional(spec_.convert(value));
  }
  update();
}

void ChartHeader::show_curve(std::size_t curve, bool shown) {
  shown_[curve] = shown;
  update();
}

void ChartHeader::set_available(std::vector<bool> available) {
  if (available != available_) {
    available_ = std::move(available);
    updateGeometry();
    update();
  }
}

void ChartHeader::set_runs(std::vector<LegendEntry> runs) {
  const int before = heightForWidth(width());
  runs_ = std::move(runs);
  if (heightForWidth(width()) != before) {
    updateGeometry();
  }
  update();
}

void ChartHeader::set_notes(std::vector<LimitLine> limits, QStringList notes) {
  const int before = heightForWidth(width());
  limits_ = std::move(limits);
  notes_ = std::move(notes);
  const Layout layout = lay_out(width());
  kept_height_ = std::max(kept_height_, layout.curves_height);
  run_below_ = run_below_ || layout.height > layout.curves_height;
  if (heightForWidth(width()) != before) {
    updateGeometry();
  }
  update();
}

void ChartHeader::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (event->size().width() != event->oldSize().width()) {
    kept_height_ = 0;
    run_below_ = false;
  }
}

int ChartHeader::row_height() const {
  return QFontMetrics(font()).height() + 4;
}

int ChartHeader::value_width() const {
  const double wide_value = spec_.decimals > 1 ? -8888 : -88888;
  return QFontMetrics(font()).horizontalAdvance(number(wide_value)) + name_gap();
}

int ChartHeader::item_width(const QString& name) const {
  return swatch_width() + name_gap() + QFontMetrics(font()).horizontalAdvance(name) + value_width();
}

int ChartHeader::run_width(const LegendEntry& run) const {
  return item_width(QFontMetrics(font()).elidedText(run.name, Qt::ElideMiddle, longest_run_name()));
}

QString ChartHeader::unit_text() const {
  return QStringLiteral("[%1]").arg(spec_.unit);
}

QString ChartHeader::number(double value) const {
  const bool none = std::abs(value) < std::pow(10, -spec_.decimals) / 2;  // no minus before zero
  return QLocale().toString(none ? 0 : value, 'f', spec_.decimals);
}

QSize ChartHeader::sizeHint() const {
  constexpr int usual_width = 700;
  // Controls beside it keep their width until it has its least one.
  return {minimumSizeHint().width(), heightForWidth(usual_width)};
}

QSize ChartHeader::minimumSizeHint() const {
  int widest = 0;
  for (const CurveSpec& curve : spec_.curves) {
    widest = std::max(widest, item_width(curve.name));
  }
  return {plot_left_margin() + widest, row_height()};
}

int ChartHeader::heightForWidth(int width) const {
  return lay_out(width).height;
}

/// What does not fit into a line goes to the next one, below the first curve.
ChartHeader::Layout ChartHeader::lay_out(int width) const {
  const QFontMetrics metrics(font());
  Layout layout;
  int x = left_inset() + QFontMetrics(bold(font())).horizontalAdvance(spec_.title) + name_gap() +
          metrics.horizontalAdvance(unit_text()) + curve_gap();
  int y = 0;
  for (std::size_t i = 0; i < spec_.curves.size(); ++i) {
    if (!available_[i]) {
      layout.curves.emplace_back();
      continue;
    }
    const int room = item_width(spec_.curves[i].name);
    if (x + room > width && x > plot_left_margin()) {
      x = plot_left_margin();
      y += row_height();
    }
    layout.curves.emplace_back(x, y, room, row_height());
    x += room + curve_gap();
  }
  QList<int> rooms;
  for (const LimitLine& limit : limits_) {
    rooms.append(swatch_width() + name_gap() + metrics.horizontalAdvance(limit.label));
  }
  for (const QString& note : notes_) {
    rooms.append(metrics.horizontalAdvance(note) + curve_gap());  // a printed font may be wider
  }
  for (const int room : rooms) {
    if (x + room > width && x > plot_left_margin()) {
      x = plot_left_margin();
      y += row_height();
    }
    layout.notes.emplace_back(x, y, std::max(0, std::min(room, width - x)), row_height());
    x += room + curve_gap();
  }
  layout.curves_height = layout.height =
      std::max(y + row_height(), width == this->width() ? kept_height_ : 0);
  const bool beside = runs_.size() == 1 && x + run_width(runs_.front()) <= width && x > plot_left_margin();
  if (beside && !(run_below_ && width == this->width())) {
    layout.runs.emplace_back(x, y, run_width(runs_.front()), row_height());
  } else if (!runs_.empty()) {
    add_runs(layout, width);
  }
  return layout;
}

void ChartHeader::add_runs(Layout& layout, int width) const {
  const QFontMetrics metrics(font());
  const int more = metrics.horizontalAdvance(tr("+ %1").arg(99));
  int x = plot_left_margin();
  int row = 0;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const int room = run_width(runs_[i]);
    const bool last = i + 1 == runs_.size();
    const int end = x + room + (last || row + 1 < max_run_rows ? 0 : curve_gap() + more);
    if (end > width && x > plot_left_margin()) {
      if (row + 1 == max_run_rows) {
        break;
      }
      ++row;
      x = plot_left_margin();
    }
    layout.runs.emplace_back(x, layout.curves_height + row * row_height(), room, row_height());
    x += room + curve_gap();
  }
  layout.height += (row + 1) * row_height();
}

QRect ChartHeader::item(std::size_t curve) const {
  return lay_out(width()).curves[curve];
}

std::optional<std::size_t> ChartHeader::curve_at(const QPoint& place) const {
  const std::vector<QRect> curves = lay_out(width()).curves;
  const auto found = std::ranges::find_if(curves, [&](const QRect& item) { return item.contains(place); });
  return found == curves.end() ? std::nullopt : std::optional<std::size_t>(found - curves.begin());
}

QString ChartHeader::tip_at(const QPoint& place) const {
  if (const auto curve = curve_at(place)) {
    return tr("%1, %2 [%3]\nClick: hide or show. Ctrl+click: only this one.")
        .arg(spec_.title, spec_.curves[*curve].name, spec_.unit);
  }
  const Layout layout = lay_out(width());
  for (std::size_t i = 0; i < layout.notes.size(); ++i) {
    if (layout.notes[i].contains(place)) {
      return i < limits_.size() ? limits_[i].label : notes_[static_cast<qsizetype>(i - limits_.size())];
    }
  }
  QStringList names;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (i < layout.runs.size() && layout.runs[i].contains(place)) {
      return runs_[i].name;
    }
    names.append(runs_[i].name);
  }
  return place.y() < layout.curves_height ? QString() : names.join('\n');
}

bool ChartHeader::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) {
    return QWidget::event(event);
  }
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), tip_at(help->pos()), this);
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
  const Layout layout = lay_out(width());
  draw_title(painter);
  for (std::size_t i = 0; i < spec_.curves.size(); ++i) {
    if (available_[i]) {
      draw_curve(painter, i, layout.curves[i]);
    }
  }
  draw_notes(painter, layout.notes);
  draw_runs(painter, layout);
}

void ChartHeader::draw_notes(QPainter& painter, const std::vector<QRect>& places) const {
  const QColor text = palette().color(QPalette::WindowText);
  for (std::size_t i = 0; i < places.size(); ++i) {
    QRect place = places[i];
    const bool limit = i < limits_.size();
    if (limit) {
      const int middle = place.center().y();
      painter.setPen(
          QPen(colour_of(limits_[i], theme_colours(palette())), line_pixels(1, *this), Qt::DashLine));
      painter.drawLine(place.left(), middle, place.left() + swatch_width(), middle);
      place.setLeft(place.left() + swatch_width() + name_gap());
    }
    const QString& words = limit ? limits_[i].label : notes_[static_cast<qsizetype>(i - limits_.size())];
    painter.setPen(text);
    painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                     limit ? words : painter.fontMetrics().elidedText(words, Qt::ElideRight, place.width()));
  }
}

void ChartHeader::draw_title(QPainter& painter) const {
  painter.setPen(palette().color(QPalette::WindowText));
  painter.setFont(bold(font()));
  const int title = QFontMetrics(painter.font()).horizontalAdvance(spec_.title);
  painter.drawText(QRect(left_inset(), 0, title + name_gap(), row_height()), Qt::AlignVCenter, spec_.title);
  painter.setFont(font());
  painter.drawText(QRect(left_inset() + title + name_gap(), 0, width(), row_height()), Qt::AlignVCenter,
                   unit_text());
}

void ChartHeader::draw_curve(QPainter& painter, std::size_t curve, const QRect& place) const {
  const CurveSpec& spec = spec_.curves[curve];
  const bool shown = shown_[curve];
  const QColor faint = palette().color(QPalette::Disabled, QPalette::WindowText);
  const QColor color = shown ? curve_colour(spec.role, theme_colours(palette())) : faint;
  const int middle = place.center().y();
  painter.setPen(QPen(color, line_pixels(shown ? spec.width + 1 : 1, *this)));
  painter.drawLine(place.left(), middle, place.left() + swatch_width(), middle);
  painter.setPen(shown ? palette().color(QPalette::WindowText) : faint);
  const QRect words = place.adjusted(swatch_width() + name_gap(), 0, 0, 0);
  painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, spec.name);
  if (shown && curve < values_.size() && values_[curve]) {
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, number(*values_[curve]));
  }
}

void ChartHeader::draw_runs(QPainter& painter, const Layout& layout) const {
  const QFontMetrics metrics(font());
  for (std::size_t i = 0; i < layout.runs.size(); ++i) {
    const LegendEntry& run = runs_[i];
    const QRect& place = layout.runs[i];
    painter.setPen(
        QPen(run.color, line_pixels(2, *this), run.dashed ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(place.left(), place.center().y(), place.left() + swatch_width(), place.center().y());
    painter.setPen(palette().color(QPalette::WindowText));
    const QRect words = place.adjusted(swatch_width() + name_gap(), 0, 0, 0);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(run.name, Qt::ElideMiddle, longest_run_name()));
    if (run.value.has_value()) {
      painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, number(*run.value));
    }
  }
  if (layout.runs.size() < runs_.size()) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::WindowText));
    painter.drawText(layout.runs.back().translated(layout.runs.back().width() + curve_gap(), 0),
                     Qt::AlignVCenter, tr("+ %1").arg(runs_.size() - layout.runs.size()));
  }
}

}  // namespace feedscope::ui
