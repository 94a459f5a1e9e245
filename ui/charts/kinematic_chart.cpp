#include "ui/charts/kinematic_chart.h"

#include <QApplication>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QMouseEvent>
#include <QPainter>
#include <QValueAxis>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "ui/charts/chart_colors.h"
#include "ui/scene/ticks.h"

namespace feedscope::ui {

namespace {

constexpr int left_margin = 64;  // the same in all charts, so that their plots stand in line
constexpr int right_margin = 14;
constexpr int top_margin = 6;
constexpr int bottom_margin = 8;
constexpr int labelled_bottom_margin = 36;
// A limit, or what may be cut, widens the chart up to this multiple of the other curves' largest value: more
// than the square root of 3 that along a line in space the path has over its axes.
constexpr double in_sight = 1.75;
constexpr double headroom = 0.06;
constexpr double tick_distance = 18;  // [px]
constexpr double zoom_a_notch = 0.8;
const QColor cursor_color(0xcc, 0x00, 0x7a);

QValueAxis* make_axis(QChart* chart, Qt::Alignment side) {
  auto* axis = new QValueAxis(chart);
  QFont font = chart->font();
  font.setPixelSize(11);
  axis->setLabelsFont(font);
  axis->setTitleFont(font);
  axis->setLabelsColor(text_color);
  axis->setTitleBrush(text_color);
  axis->setGridLineColor(grid_color);
  axis->setLinePenColor(axis_color);
  axis->setTickType(QValueAxis::TicksDynamic);
  axis->setTickAnchor(0);
  axis->setTruncateLabels(false);
  chart->addAxis(axis, side);
  return axis;
}

float magnitude(const Extent& extent) {
  return extent.empty() ? 0.0F : std::max(extent.max, -extent.min);
}

void set_range(QValueAxis* axis, double lower, double upper, int most_ticks) {
  const double step = round_up_125((upper - lower) / most_ticks);
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  axis->setTickInterval(step);
  axis->setLabelFormat(QStringLiteral("%.%1f").arg(decimals));
  axis->setRange(lower, upper);
}

}  // namespace

KinematicChart::KinematicChart(ChartSpec spec, ViewRange& range, bool labelled, QWidget* parent)
    : QChartView(parent), spec_(std::move(spec)), range_(range), labelled_(labelled) {
  chart()->legend()->hide();
  chart()->setBackgroundRoundness(0);
  chart()->setBackgroundBrush(Qt::white);
  chart()->setMargins({});
  chart()->setLocalizeNumbers(true);
  chart()->setAnimationOptions(QChart::NoAnimation);
  chart()->layout()->setContentsMargins(0, 0, 0, 0);
  abscissa_ = make_axis(chart(), Qt::AlignBottom);
  abscissa_->setLabelsVisible(labelled);
  ordinate_ = make_axis(chart(), Qt::AlignLeft);
  for (std::size_t i = 0; i < spec_.curves.size(); ++i) {
    auto* series = new QLineSeries(chart());
    chart()->addSeries(series);
    series->attachAxis(abscissa_);
    series->attachAxis(ordinate_);
    layers_.push_back(series);
  }
  setRenderHint(QPainter::Antialiasing);
  setFrameShape(QFrame::NoFrame);
  setMinimumHeight(labelled ? 90 : 60);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setToolTip(tr("Click: cursor. Wheel: zoom. Drag: pan. Double click: show all."));
  connect(scene(), &QGraphicsScene::changed, this, [this] {
    picture_ = {};
    viewport()->update();
  });
}

int KinematicChart::column_count() const {
  return std::max(1, viewport()->width() - left_margin - right_margin);
}

void KinematicChart::set_limits(std::vector<LimitLine> limits) {
  limits_ = std::move(limits);
}

void KinematicChart::set_abscissa_title(const QString& title) {
  abscissa_->setTitleText(title);
}

void KinematicChart::show_bands(std::span<const Band> bands) {
  const double column = (range_.upper() - range_.lower()) / static_cast<double>(bands.size());
  std::vector<Extent> extents(spec_.curves.size());
  std::vector<QList<QPointF>> points(spec_.curves.size());
  for (std::size_t k = 0; k < spec_.curves.size(); ++k) {
    points[k].reserve(2 * static_cast<qsizetype>(bands.size()));
    for (std::size_t i = 0; i < bands.size(); ++i) {
      const Extent& extent = bands[i][spec_.curves[k].channel];
      if (extent.empty()) {
        continue;
      }
      extents[k].add(extent);
      const double x = range_.lower() + (static_cast<double>(i) + 0.5) * column;
      double first = spec_.convert(double{extent.min});
      double second = spec_.convert(double{extent.max});
      const double before = points[k].isEmpty() ? first : points[k].back().y();
      if (std::abs(before - second) < std::abs(before - first)) {
        std::swap(first, second);
      }
      points[k].append({x, first});
      if (first != second) {
        points[k].append({x, second});
      }
    }
  }
  stack_curves(extents, points);
  fit_values(extents);
  const int most_ticks = std::max(2, column_count() / 80);
  set_range(abscissa_, range_.lower(), range_.upper(), most_ticks);
  picture_ = {};
  viewport()->update();
}

void KinematicChart::stack_curves(const std::vector<Extent>& extents,
                                  const std::vector<QList<QPointF>>& points) {
  std::vector<std::size_t> order(extents.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t k) { return magnitude(extents[k]); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const CurveSpec& curve = spec_.curves[order[i]];
    QPen pen(curve.color, curve.width);
    pen.setJoinStyle(Qt::BevelJoin);
    layers_[i]->setPen(pen);
    layers_[i]->replace(points[order[i]]);
  }
}

void KinematicChart::fit_values(const std::vector<Extent>& extents) {
  double lower = 0;
  double upper = 0;
  for (std::size_t k = 0; k < extents.size(); ++k) {
    if (!spec_.curves[k].may_be_cut && !extents[k].empty()) {
      lower = std::min(lower, spec_.convert(double{extents[k].min}));
      upper = std::max(upper, spec_.convert(double{extents[k].max}));
    }
  }
  const double sight = in_sight * std::max(upper, -lower);
  for (std::size_t k = 0; k < extents.size(); ++k) {
    if (spec_.curves[k].may_be_cut && !extents[k].empty()) {
      lower = std::min(lower, std::max(-sight, spec_.convert(double{extents[k].min})));
      upper = std::max(upper, std::min(sight, spec_.convert(double{extents[k].max})));
    }
  }
  for (const LimitLine& limit : limits_) {
    if (limit.value <= sight) {
      upper = upper > 0 ? std::max(upper, limit.value) : upper;
      lower = lower < 0 ? std::min(lower, -limit.value) : lower;
    }
  }
  if (!(upper > lower)) {
    upper = 1;
  }
  const double room = headroom * (upper - lower);
  const int most_ticks = std::max(3, static_cast<int>(chart()->plotArea().height() / tick_distance));
  set_range(ordinate_, lower < 0 ? lower - room : 0, upper > 0 ? upper + room : 0, most_ticks);
}

void KinematicChart::set_cursor(std::optional<double> position) {
  cursor_ = position;
  viewport()->update();
}

double KinematicChart::pixel_of(double position) const {
  const QRectF plot = chart()->plotArea();
  return plot.left() + (position - range_.lower()) / (range_.upper() - range_.lower()) * plot.width();
}

double KinematicChart::position_at(double pixel) const {
  const QRectF plot = chart()->plotArea();
  return range_.lower() + (pixel - plot.left()) / plot.width() * (range_.upper() - range_.lower());
}

void KinematicChart::paintEvent(QPaintEvent*) {
  if (picture_.isNull()) {
    picture_ = QPixmap(viewport()->size() * devicePixelRatioF());
    picture_.setDevicePixelRatio(devicePixelRatioF());
    picture_.fill(Qt::white);
    QPainter painter(&picture_);
    painter.setRenderHint(QPainter::Antialiasing);
    render(&painter, QRectF(viewport()->rect()), viewport()->rect());
    draw_limits(painter);
  }
  QPainter painter(viewport());
  painter.drawPixmap(0, 0, picture_);
  draw_cursor(painter);
}

void KinematicChart::draw_limits(QPainter& painter) const {
  const QRectF plot = chart()->plotArea();
  painter.setClipRect(plot);
  QFont font = painter.font();
  font.setPixelSize(10);
  painter.setFont(font);
  const QFontMetricsF metrics(font);
  double label_right = plot.right() - 4;
  for (const LimitLine& limit : limits_) {
    const double top = chart()->mapToPosition({range_.lower(), limit.value}).y();
    painter.setPen(QPen(limit.color, 1, Qt::DashLine));
    painter.drawLine(QPointF(plot.left(), top), QPointF(plot.right(), top));
    const double bottom = chart()->mapToPosition({range_.lower(), -limit.value}).y();
    painter.drawLine(QPointF(plot.left(), bottom), QPointF(plot.right(), bottom));
    if (top > plot.top()) {
      const double width = metrics.horizontalAdvance(limit.label);
      const QRectF box(label_right - width, top + 1, width, metrics.height());
      painter.fillRect(box.adjusted(-2, 1, 2, -1), QColor(255, 255, 255, 230));
      painter.drawText(box, Qt::AlignCenter, limit.label);
      label_right -= width + 12;
    }
  }
}

void KinematicChart::draw_cursor(QPainter& painter) const {
  const QRectF plot = chart()->plotArea();
  if (cursor_.has_value() && *cursor_ >= range_.lower() && *cursor_ <= range_.upper()) {
    painter.setPen(QPen(cursor_color, 1));
    const double x = std::round(pixel_of(*cursor_));
    painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
  }
}

void KinematicChart::resizeEvent(QResizeEvent* event) {
  QChartView::resizeEvent(event);
  const int bottom = labelled_ ? labelled_bottom_margin : bottom_margin;
  chart()->setPlotArea(QRectF(viewport()->rect()).adjusted(left_margin, top_margin, -right_margin, -bottom));
  picture_ = {};
  emit plot_resized();
}

void KinematicChart::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  range_.zoom(std::pow(zoom_a_notch, notches), position_at(event->position().x()));
  event->accept();
}

void KinematicChart::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    pressed_at_ = event->position();
    dragged_from_ = event->position();
    dragging_ = false;
  }
}

void KinematicChart::mouseMoveEvent(QMouseEvent* event) {
  if (!event->buttons().testFlag(Qt::LeftButton)) {
    return;
  }
  if ((event->position() - pressed_at_).manhattanLength() >= QApplication::startDragDistance()) {
    dragging_ = true;
  }
  if (dragging_) {
    range_.pan(position_at(dragged_from_.x()) - position_at(event->position().x()));
    dragged_from_ = event->position();
  }
}

void KinematicChart::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !dragging_) {
    emit position_clicked(position_at(event->position().x()));
  }
}

void KinematicChart::mouseDoubleClickEvent(QMouseEvent*) {
  dragging_ = true;  // the release that follows is no click
  range_.fit();
}

}  // namespace feedscope::ui
