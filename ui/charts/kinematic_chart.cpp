#include "ui/charts/kinematic_chart.h"

#include <QContextMenuEvent>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/base/ticks.h"
#include "ui/charts/chart_input.h"
#include "ui/charts/curve_columns.h"
#include "ui/charts/mean_line.h"
#include "ui/charts/plot_margins.h"
#include "ui/charts/usual_band.h"
#include "ui/charts/value_ticks.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {
namespace {

constexpr int least_height = 48;
constexpr int least_labelled_height = 64;
constexpr int label_size = 11;
constexpr int top_margin = 3;
constexpr int bottom_margin = 3;
constexpr int labelled_bottom_margin = 20;
constexpr int tick_distance = 14;  // [px]
constexpr int tick_gap = 6;        // [px] from a tick's label to the plot
constexpr double overlay_width = 1.4;
constexpr double band_edge = 1.3;
constexpr double finest_zoom = 1e-6;  // of the largest value; finer, all tick labels are equal
constexpr double widest_values = 1e12;

QFont label_font() {
  QFont font;
  font.setPixelSize(type_pixels(label_size));
  return font;
}

QColor mixed(const QColor& a, const QColor& b, double share_of_b) {
  const auto part = [&](int one, int other) {
    return static_cast<int>(std::lround(std::lerp(one, other, share_of_b)));
  };
  return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

float magnitude(const std::vector<Extent>& columns) {
  float largest = 0;
  for (const Extent& extent : columns) {
    largest = extent.empty() ? largest : std::max({largest, extent.max, -extent.min});
  }
  return largest;
}

std::vector<ColumnSpan> spans_of(const KinematicChart& chart, const std::vector<Extent>& extents) {
  const QRectF& plot = chart.plot();
  const double beyond = plot.height();  // far values would overflow the rasterizer
  const auto to_pixel = [&](float value) {
    const double height = chart.height_of(chart.spec().convert(double{value}));
    return std::clamp(height, plot.top() - beyond, plot.bottom() + beyond);
  };
  std::vector<ColumnSpan> spans(extents.size());
  for (std::size_t i = 0; i < extents.size(); ++i) {
    if (!extents[i].empty()) {
      spans[i] = {to_pixel(extents[i].max), to_pixel(extents[i].min)};
    }
  }
  return spans;
}

}  // namespace

KinematicChart::KinematicChart(ChartSpec spec, ViewRange& range, QWidget* parent)
    : QWidget(parent),
      spec_(std::move(spec)),
      range_(range),
      columns_(spec_.curves.size()),
      usual_(spec_.curves.size()),
      shown_(spec_.curves.size(), true),
      input_(new ChartInput(*this, range)) {
  std::transform(spec_.curves.begin(), spec_.curves.end(), shown_.begin(),
                 [](const CurveSpec& curve) { return !curve.on_demand; });
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setFocusPolicy(Qt::StrongFocus);
  setToolTip(
      tr("Click: cursor. Shift+click: second cursor, differences. Wheel: zoom. Drag: pan.\n"
         "Right drag or Ctrl+drag: zoom to a box. Ctrl+wheel: zoom the values. Double click: show all."));
  follow_type_size();
  connect(&TypeSize::of_application(), &TypeSize::changed, this, &KinematicChart::follow_type_size);
}

void KinematicChart::redraw() {
  picture_ = {};
  update();
}

int KinematicChart::column_count() const {
  const int across = std::max(1, width() - plot_left_margin() - plot_right_margin);
  return static_cast<int>(std::lround(across * devicePixelRatioF() * resolution_));
}

void KinematicChart::set_limits(std::vector<LimitLine> limits) {
  limits_ = std::move(limits);
}

void KinematicChart::label_abscissa(const QString& title) {
  abscissa_title_ = title;
  follow_type_size();
}

void KinematicChart::follow_type_size() {
  setMinimumHeight(type_pixels(abscissa_title_.isEmpty() ? least_height : least_labelled_height));
  lay_out();
  redraw();
}

void KinematicChart::show_curve(std::size_t curve, bool shown) {
  shown_[curve] = shown;
  fit();
}

void KinematicChart::show_bands(std::span<const Band> bands, std::vector<OverlayCurve> overlays) {
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    columns_[k].resize(bands.size());
    for (std::size_t i = 0; i < bands.size(); ++i) {
      columns_[k][i] = bands[i][spec_.curves[k].quantity];
    }
  }
  overlays_ = std::move(overlays);
  fit();
}

void KinematicChart::choose_values(const std::optional<Interval>& values) {
  const bool usable =
      !values.has_value() ||
      (values->width() > finest_zoom * std::max(std::abs(values->lower), std::abs(values->upper)) &&
       values->width() < widest_values);
  if (usable && values != chosen_values_) {
    chosen_values_ = values;
    fit();
    emit values_chosen();
  }
}

CurveReach KinematicChart::reach_of(const std::vector<Extent>& columns, bool may_be_cut) const {
  Extent whole;
  for (const Extent& extent : columns) {
    whole.add(extent);
  }
  if (!whole.empty()) {
    whole = {static_cast<float>(spec_.convert(double{whole.min})),
             static_cast<float>(spec_.convert(double{whole.max}))};
  }
  return {whole, may_be_cut};
}

void KinematicChart::set_cutting_feed(const std::optional<CuttingFeed>& feed) {
  cutting_feed_ = feed;
  if (feed) {
    *cutting_feed_ = {spec_.convert(feed->achieved), spec_.convert(feed->programmed), feed->without_peaks};
  }
}

std::optional<CuttingFeed> KinematicChart::cutting_values() const {
  if (cutting_feed_ || cutting_.empty()) {
    return cutting_feed_;
  }
  double largest = 0;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const CurveSpec& curve = spec_.curves[k];
    if (!shown_[k] || curve.may_be_cut) {
      continue;
    }
    if (info_of(curve.quantity).source != QuantitySource::motion) {
      return std::nullopt;  // unknown of the machine's own axes
    }
    for (const MotionBand& run : cutting_) {
      if (const Extent& extent = run[curve.quantity]; !extent.empty()) {
        largest = std::max({largest, double{extent.max}, -double{extent.min}});
      }
    }
  }
  largest = spec_.convert(largest);
  return CuttingFeed{largest, largest};
}

/// Fits the axes to the shown curves.
void KinematicChart::fit() {
  std::vector<CurveReach> curves;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (shown_[k]) {
      curves.push_back(reach_of(columns_[k], spec_.curves[k].may_be_cut));
    }
  }
  for (const OverlayCurve& overlay : overlays_) {
    curves.push_back(reach_of(overlay.columns, false));
  }
  shown_limits_ = limits_of_moving(limits_, [this](const LimitLine& limit) { return moves(limit); });
  std::vector<double> limits;
  for (const LimitLine& limit : shown_limits_) {
    limits.push_back(limit.value);
  }
  values_ = fit_values(curves, limits);
  double fastest = 0;
  for (const CurveReach& curve : curves) {
    if (!curve.may_be_cut && !curve.values.empty()) {
      fastest = std::max({fastest, double{curve.values.max}, -double{curve.values.min}});
    }
  }
  fastest_rapid_.reset();
  const auto cutting = cutting_values();
  const auto slower = cutting ? without_rapids(values_, fastest, *cutting) : std::nullopt;
  if (slower && !chosen_values_) {
    fastest_rapid_ = fastest;
    values_ = *slower;
  }
  values_ = chosen_values_.value_or(values_);
  programmed_beyond_.reset();
  for (std::size_t k = 0; k < columns_.size() && !fastest_rapid_ && !chosen_values_; ++k) {
    if (shown_[k] && spec_.curves[k].quantity == QuantityId::programmed_feed) {
      const Extent programmed = reach_of(columns_[k], true).values;
      const double most = cutting_feed_ ? cutting_feed_->programmed : double{programmed.max};  // no rapids
      if (!programmed.empty() && std::min(most, double{programmed.max}) > values_.upper) {
        programmed_beyond_ = std::min(most, double{programmed.max});
      }
    }
  }
  ordinate_step_ =
      tick_step(values_, std::max(2, static_cast<int>(plot_.height() / type_pixels(tick_distance))),
                values_.width() * type_pixels(tick_distance + 1) / std::max(1.0, plot_.height()));
  redraw();
}

double KinematicChart::abscissa_step() const {
  return tick_step({range_.lower(), range_.upper()},
                   std::max(2, static_cast<int>(plot_.width() / type_pixels(80))));
}

void KinematicChart::set_cursors(std::optional<double> first, std::optional<double> second) {
  cursor_ = first;
  second_cursor_ = second;
  update();
}

double KinematicChart::pixel_of(double position) const {
  return plot_.left() + (position - range_.lower()) / (range_.upper() - range_.lower()) * plot_.width();
}

double KinematicChart::position_at(double pixel) const {
  return range_.lower() + (pixel - plot_.left()) / plot_.width() * (range_.upper() - range_.lower());
}

double KinematicChart::height_of(double value) const {
  return plot_.bottom() - (value - values_.lower) / values_.width() * plot_.height();
}

double KinematicChart::value_at(double height) const {
  return values_.lower + (plot_.bottom() - height) / plot_.height() * values_.width();
}

bool KinematicChart::event(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    redraw();
  }
  return QWidget::event(event);
}

void KinematicChart::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() == QContextMenuEvent::Mouse) {
    event->accept();  // the release of the button decides between box and menu
  } else {
    emit menu_requested(mapToGlobal(plot_.center().toPoint()));
  }
}

void KinematicChart::paintEvent(QPaintEvent*) {
  if (picture_.isNull()) {
    picture_ = QPixmap(size() * devicePixelRatioF());
    picture_.setDevicePixelRatio(devicePixelRatioF());
    QPainter painter(&picture_);
    draw_picture(painter);
  }
  QPainter painter(this);
  painter.drawPixmap(0, 0, picture_);
  draw_cursors(painter);
  if (const std::optional<QRectF> box = input_->box()) {
    QColor fill = palette().color(QPalette::Highlight);
    painter.setPen(fill);
    fill.setAlpha(50);
    painter.setBrush(fill);
    painter.drawRect(*box);
  }
}

void KinematicChart::draw(QPainter& painter) const {
  draw_picture(painter);
  draw_cursors(painter);
}

void KinematicChart::draw_picture(QPainter& painter) const {
  const ThemeColours& colours = theme_colours(palette());
  painter.fillRect(rect(), colours.plot);
  painter.setRenderHint(QPainter::Antialiasing);
  ground_.draw(painter, rect(), plot_, {{range_.lower(), range_.upper()}, abscissa_step()},
               {values_, ordinate_step_}, colours);
  painter.save();
  painter.setClipRect(plot_);
  draw_curves(painter);
  draw_mean_lines(painter, mean_lines(), curve_colour(CurveRole::path, colours), colours.plot,
                  line_pixels(1, *this));
  draw_limit_lines(painter, plot_, shown_limits_, colours, line_pixels(1, *this),
                   [this](double value) { return height_of(value); });
  painter.restore();
  draw_ordinate(painter);
  if (!abscissa_title_.isEmpty()) {
    draw_abscissa(painter);
  }
}

void KinematicChart::draw_ordinate(QPainter& painter) const {
  const QFontMetricsF metrics(label_font());
  const double right = plot_.left() - type_pixels(tick_gap);
  const double largest = std::max(std::abs(values_.lower), std::abs(values_.upper));
  painter.setFont(label_font());
  painter.setPen(theme_colours(palette()).text);
  for (const double tick : multiples(ordinate_step_, values_.lower, values_.upper)) {
    const QRectF place(0, height_of(tick) - metrics.height() / 2, right, metrics.height());
    painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip,
                     tick_text(tick, ordinate_step_, largest));
  }
}

/// Draws the tick labels, the last one moved to the left where it would be cut off, and the title in their
/// row: left of them, or in place of those at the right end.
void KinematicChart::draw_abscissa(QPainter& painter) const {
  const QFontMetricsF metrics(label_font());
  QRectF row(0, height() - metrics.height() - 2, width(), metrics.height());
  painter.setFont(label_font());
  painter.setPen(theme_colours(palette()).text);
  const double wide = metrics.horizontalAdvance(abscissa_title_) + 4;
  constexpr double half_label = 8;  // [px], of the 0 at the left end
  const bool left = wide <= plot_.left() - half_label;
  const double title = left ? plot_.left() - half_label - wide : row.right() - wide;
  painter.drawText(QRectF(title, row.top(), wide, row.height()), Qt::AlignCenter, abscissa_title_);
  (left ? row.setLeft(title + wide) : row.setRight(title));
  const double step = abscissa_step();
  for (const double tick : multiples(step, range_.lower(), range_.upper())) {
    const QString number = tick_text(tick, step);
    const double half = metrics.horizontalAdvance(number) / 2;
    QRectF place(pixel_of(tick) - half, row.top(), 2 * half, row.height());
    place.moveRight(std::min(place.right(), width() - 1.0));
    if (place.left() >= row.left() && place.right() <= row.right()) {
      painter.drawText(place, Qt::AlignCenter | Qt::TextDontClip, number);
      row.setLeft(place.right() + half_label);
    }
  }
}

/// Draws the largest curve first, so that none hides another; the insides of oscillating curves go under all.
void KinematicChart::draw_curves(QPainter& painter) const {
  for (const OverlayCurve& overlay : overlays_) {
    draw_extents(painter, overlay.columns, overlay.color, line_pixels(overlay_width, *this), overlay.dashed);
  }
  std::vector<float> size(columns_.size());
  std::ranges::transform(columns_, size.begin(), magnitude);
  std::vector<std::size_t> order(columns_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t k) { return size[k]; });
  std::erase_if(order, [&](std::size_t k) { return !shown_[k]; });
  const ThemeColours& colours = theme_colours(palette());
  if (shows_usual()) {
    // One curve with extremes and band, the others as edges of their bands: overlapping bands would hide all
    // curves.
    const std::size_t filled = std::ranges::min(order);
    constexpr double pale = 0.22;
    draw_columns(painter, plot_, spans_of(*this, columns_[filled]),
                 {mixed(colours.plot, curve_colour(spec_.curves[filled].role, colours), pale), 1});
    // The last stretch may extend beyond the end of the run.
    const auto last = std::find_if_not(columns_.front().rbegin(), columns_.front().rend(),
                                       [](const Extent& column) { return column.empty(); });
    QRectF run = plot_;
    run.setWidth(plot_.width() * static_cast<double>(columns_.front().rend() - last) /
                 static_cast<double>(columns_.front().size()));
    painter.save();
    painter.setClipRect(run, Qt::IntersectClip);
    for (const std::size_t k : order) {
      if (!means_.empty() && k > 0) {
        continue;  // the other bands would hide the mean of one curve
      }
      draw_usual_band(painter, plot_, spans_of(*this, usual_[k]), columns_a_stretch_, columns_[k].size(),
                      curve_colour(spec_.curves[k].role, colours), line_pixels(band_edge, *this),
                      k == filled ? BandFill::pale : BandFill::none);
    }
    painter.restore();
    return;
  }
  for (const std::size_t k : order) {
    constexpr double pale = 0.3;
    const QColor colour = curve_colour(spec_.curves[k].role, colours);
    fill_hollows(painter, plot_, spans_of(*this, columns_[k]),
                 {mixed(colours.plot, colour, pale), line_pixels(spec_.curves[k].width, *this)});
  }
  for (const std::size_t k : order) {
    const CurveSpec& curve = spec_.curves[k];
    draw_extents(painter, columns_[k], curve_colour(curve.role, colours), line_pixels(curve.width, *this),
                 false);
  }
}

void KinematicChart::draw_extents(QPainter& painter, const std::vector<Extent>& extents, const QColor& color,
                                  double width, bool dashed) const {
  draw_columns(painter, plot_, spans_of(*this, extents), {color, width, dashed, true});
}

void KinematicChart::set_usual(const std::vector<MotionBand>& ranges, std::size_t columns) {
  columns_a_stretch_ = columns;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const QuantityId id = spec_.curves[k].quantity;  // the machine's own axes have no usual range
    usual_[k].assign(spec_.source == QuantitySource::motion ? ranges.size() : 0, {});
    for (std::size_t i = 0; i < usual_[k].size() && info_of(id).source == spec_.source; ++i) {
      usual_[k][i] = ranges[i][id];
    }
  }
  redraw();
}

bool KinematicChart::shows_usual() const {
  if (usual_.empty() || usual_.front().empty()) {
    return false;
  }
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (shown_[k] && says_more(spans_of(*this, usual_[k]), spans_of(*this, columns_[k]))) {
      return true;
    }
  }
  return false;
}

void KinematicChart::set_means(std::vector<float> means) {
  means_ = std::move(means);
}

std::vector<QPolygonF> KinematicChart::mean_lines() const {
  if (means_.empty() || columns_.empty() || !shown_.front()) {
    return {};
  }
  const std::vector<ColumnSpan> columns = spans_of(*this, columns_.front());
  return ui::mean_lines(
      plot_, columns, means_, [this](double value) { return height_of(spec_.convert(value)); },
      shows_usual() && hidden_in_bars(columns));
}

QStringList KinematicChart::notes() const {
  QStringList notes;
  const auto up_to = [&](const QString& text, double value) {
    notes.append(text.arg(QLocale().toString(value, 'f', spec_.decimals)));
  };
  if (fastest_rapid_) {
    up_to(cutting_feed_ && cutting_feed_->without_peaks ? tr("▴ peaks up to %1") : tr("▴ rapids up to %1"),
          *fastest_rapid_);
  }
  if (programmed_beyond_) {
    up_to(tr("▴ programmed up to %1"), *programmed_beyond_);
  }
  if (shows_usual()) {
    notes.append(tr("bands: 5 to 95 % of the time, pale: extremes"));
  }
  if (!mean_lines().empty()) {
    notes.append(shows_usual() ? tr("line: mean feed") : tr("line: mean of the columns"));
  }
  if (jumps_) {
    notes.append(tr("jumps of the acceleration are not drawn"));
  }
  return notes;
}

bool KinematicChart::moves(const LimitLine& limit) const {
  constexpr double rounding = 1e-6;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const Extent values = reach_of(columns_[k], false).values;
    const auto axis = static_cast<int>(limit.axes.front());
    if (shown_[k] && info_of(spec_.curves[k].quantity).axis == axis && !values.empty() &&
        std::max(double{values.max}, -double{values.min}) > rounding * limit.value) {
      return true;
    }
  }
  return false;
}

std::vector<LimitLine> KinematicChart::limits_in_sight() const {
  std::vector<LimitLine> seen;
  std::ranges::copy_if(shown_limits_, std::back_inserter(seen), [this](const LimitLine& limit) {
    return limit.value > values_.lower && limit.value < values_.upper;
  });
  return seen;
}

void KinematicChart::draw_cursors(QPainter& painter) const {
  const ThemeColours& colours = theme_colours(palette());
  if (cursor_.has_value() && second_cursor_.has_value()) {
    const double from = std::max(plot_.left(), pixel_of(std::min(*cursor_, *second_cursor_)));
    const double to = std::min(plot_.right(), pixel_of(std::max(*cursor_, *second_cursor_)));
    QColor between = colours.second_cursor;
    between.setAlpha(32);
    if (to > from) {
      painter.fillRect(QRectF(from, plot_.top(), to - from, plot_.height()), between);
    }
  }
  const auto line = [&](const std::optional<double>& position, const QColor& color, const char* name) {
    if (position.has_value() && *position >= range_.lower() && *position <= range_.upper()) {
      painter.setPen(QPen(color, line_pixels(1, *this)));
      const double x = std::round(pixel_of(*position));
      painter.drawLine(QPointF(x, plot_.top()), QPointF(x, plot_.bottom()));
      if (second_cursor_.has_value()) {
        painter.drawText(QRectF(x + 3, plot_.top(), type_pixels(12), type_pixels(12)),
                         Qt::AlignLeft | Qt::AlignVCenter, name);
      }
    }
  };
  QFont small = font();
  small.setPixelSize(type_pixels(10));
  painter.setFont(small);
  line(second_cursor_, colours.second_cursor, "B");
  line(cursor_, colours.cursor, "A");
}

void KinematicChart::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  lay_out();
}

void KinematicChart::lay_out() {
  // Room for half a line above and below, so that tick labels at the ends fit in any font.
  const int line = QFontMetrics(label_font()).height();
  const int top = std::max(type_pixels(top_margin), (line + 1) / 2);
  const int bottom = std::max(
      (line + 1) / 2, abscissa_title_.isEmpty() ? bottom_margin : type_pixels(labelled_bottom_margin));
  plot_ = QRectF(rect()).adjusted(plot_left_margin(), top, -plot_right_margin, -bottom);
  picture_ = {};
  emit plot_resized();
}

}  // namespace feedscope::ui
