#include "ui/study/study_map.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QSet>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/analysis/study/recommendation.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"
#include "ui/language/texts.h"
#include "ui/scene/colour_map.h"
#include "ui/shared/plot_grid.h"
#include "ui/shared/plot_text.h"
#include "ui/study/study_curves.h"

namespace feedscope::ui {

namespace {

struct MapTexts {
  Q_DECLARE_TR_FUNCTIONS(feedscope::ui::StudyMapPicture)
};

constexpr double map_margin = 14;
constexpr double map_gap = 30;  // between maps
constexpr double beside_map = 62;
constexpr double ring_pen = 1.8;
constexpr QSize natural_map(466, 340);
constexpr QSize single_map(932, 520);
constexpr QSize least_map(240, 200);
const QColor map_ink(0x22, 0x26, 0x2a);
const QColor map_grid(0xd5, 0xd9, 0xde);
const QColor impossible_ink(0xb4, 0xba, 0xc2);

/// Texts with as few digits as distinguish them, at least two.
QStringList axis_texts(const std::vector<double>& values) {
  constexpr int most_digits = 15;
  QStringList texts;
  for (int digits = 2; digits <= most_digits; ++digits) {
    texts.clear();
    for (const double value : values) {
      texts.append(significant_number(value, digits));
    }
    if (QSet<QString>(texts.begin(), texts.end()).size() == texts.size()) {
      break;
    }
  }
  return texts;
}

QString with_unit(const QString& text, const QString& unit) {
  return unit.isEmpty() ? text : QStringLiteral("%1 [%2]").arg(text, unit);
}

/// Indices of values in ascending order.
std::vector<std::size_t> rising_order(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
  return order;
}

StudyMapAxis map_axis(const Sweep& sweep) {
  const KeyUnit unit = key_unit(sweep_unit(sweep.key));
  StudyMapAxis axis{setting_title(sweep.key), unit.text, sweep.values};
  std::ranges::sort(axis.values);
  for (double& value : axis.values) {
    value *= unit.factor;
  }
  return axis;
}

StudyMap map_of(const Study& study, std::span<const StudyRun> runs) {
  const std::vector<std::size_t> columns = rising_order(study.sweeps[0].values);
  const std::vector<std::size_t> rows = rising_order(study.sweeps[1].values);
  const std::vector<bool> marks = recommended_marks(runs, study.within);
  StudyMap map{family_name(study, runs.front()), {}};
  for (const std::size_t row : rows) {
    for (const std::size_t column : columns) {
      const std::size_t i = row * columns.size() + column;
      map.cells.push_back({runs[i].summary.cycle_time, deciding_error(runs[i].summary), runs[i].is_possible(),
                           runs[i].lines_not_run, marks[i]});
    }
  }
  return map;
}

/// Round bounds that divide the times of all runs into at most StudyMapPicture::most_colours parts.
Ticks time_bounds(const StudyMaps& study) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const StudyMap& map : study.maps) {
    for (const StudyMapCell& cell : map.cells) {
      low = cell.possible ? std::min(low, cell.time) : low;
      high = cell.possible ? std::max(high, cell.time) : high;
    }
  }
  constexpr double level_span = 1e-6;  // of the time: smaller differences are rounding
  return high - low > level_span * high ? clock_ticks(low, high, StudyMapPicture::most_colours - 1) : Ticks();
}

double largest_error(const StudyMaps& study) {
  double largest = 0;
  for (const StudyMap& map : study.maps) {
    for (const StudyMapCell& cell : map.cells) {
      largest = cell.possible ? std::max(largest, cell.error) : largest;
    }
  }
  return largest;
}

/// Whether a line of the error `level` [mm] is drawn in any of the maps.
bool is_crossed(const StudyMaps& study, double level) {
  return std::ranges::any_of(study.maps, [&](const StudyMap& map) {
    return !contour_pieces(map, study.x.values.size(), level).empty();
  });
}

std::vector<double> error_levels(const StudyMaps& study) {
  constexpr int most_levels = 6;
  std::vector<double> levels;
  for (const double level :
       round_ticks(0, in_shown_unit(largest_error(study), Dimension::error), most_levels).values) {
    const double error = from_shown_unit(level, Dimension::error);
    constexpr double rounding = 1e-9;
    if (level > 0 && !(study.within && std::abs(error - *study.within) <= rounding * error) &&
        is_crossed(study, error)) {
      levels.push_back(error);
    }
  }
  return levels;
}

std::size_t columns_of_maps(std::size_t maps) {
  return maps <= 1 ? 1 : maps <= 4 ? 2 : 3;
}

std::size_t rows_of_maps(std::size_t maps) {
  return (maps + columns_of_maps(maps) - 1) / columns_of_maps(maps);
}

/// Size of a picture of `maps` maps with title and legend.
QSize picture_size(std::size_t maps, const QSize& map) {
  constexpr int title_and_legend = 100;
  const auto across = static_cast<int>(columns_of_maps(maps));
  const auto down = static_cast<int>(rows_of_maps(maps));
  constexpr int gap = static_cast<int>(map_gap);
  return {across * map.width() + (across - 1) * gap + 2 * static_cast<int>(map_margin),
          down * map.height() + title_and_legend};
}

/// Draws a dark line with a light rim, visible on every colour of the map.
void draw_rimmed(QPainter& painter, const QLineF& line, const QPen& pen) {
  QPen rim(QColor(255, 255, 255, 190), pen.widthF() + 1.6);
  rim.setCapStyle(Qt::FlatCap);
  painter.setPen(rim);
  painter.drawLine(line);
  painter.setPen(pen);
  painter.drawLine(line);
}

QPen contour_pen(bool is_bound) {
  QPen pen(map_ink, is_bound ? 1.8 : 0.9);
  pen.setStyle(is_bound ? Qt::DashLine : Qt::SolidLine);
  pen.setCapStyle(Qt::FlatCap);
  return pen;
}

void draw_ring(QPainter& painter, const QRectF& around) {
  painter.setBrush(Qt::NoBrush);
  for (const QPen& pen : {QPen(Qt::white, ring_pen + 2.4), QPen(map_ink, ring_pen)}) {
    painter.setPen(pen);
    painter.drawRoundedRect(around, around.height() / 2, around.height() / 2);
  }
}

}  // namespace

StudyMaps study_maps(const Study& study) {
  StudyMaps shown{
      map_axis(study.sweeps[0]), map_axis(study.sweeps[1]), study.within, errors_are_actual(study), {}};
  const std::size_t count = shown.x.values.size() * shown.y.values.size();
  for (std::size_t first = 0; first + count <= study.runs.size(); first += count) {
    shown.maps.push_back(map_of(study, std::span(study.runs).subspan(first, count)));
  }
  return shown;
}

namespace {

/// Four neighbouring cells, anticlockwise from the lowest column and row.
struct CellSquare {
  std::array<QPointF, 4> corners;
  std::array<double, 4> errors{};  ///< [mm]
  bool possible = true;            ///< whether all of them are
};

CellSquare square_at(const StudyMap& map, std::size_t columns, std::size_t column, std::size_t row) {
  CellSquare square;
  constexpr std::array<std::array<std::size_t, 2>, 4> steps{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::size_t x = column + steps[i][0];
    const std::size_t y = row + steps[i][1];
    const StudyMapCell& cell = map.cells[y * columns + x];
    square.corners[i] = QPointF(static_cast<double>(x), static_cast<double>(y));
    square.errors[i] = cell.error;
    square.possible = square.possible && cell.possible;
  }
  return square;
}

/// On a saddle the lines cut off the corners on the other side of `level` than the mean of all four.
void add_pieces(const CellSquare& square, double level, std::vector<QLineF>& pieces) {
  std::array<QPointF, 4> crossings;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    if ((square.errors[i] < level) != (square.errors[next] < level)) {
      const double share = (level - square.errors[i]) / (square.errors[next] - square.errors[i]);
      crossings[count++] = square.corners[i] + share * (square.corners[next] - square.corners[i]);
    }
  }
  const double mean = (square.errors[0] + square.errors[1] + square.errors[2] + square.errors[3]) / 4;
  const std::size_t first = count == 4 && (mean < level) != (square.errors[0] < level) ? 1 : 0;
  for (std::size_t i = first; i < count + first; i += 2) {
    pieces.emplace_back(crossings[i], crossings[(i + 1) % count]);
  }
}

}  // namespace

std::vector<QLineF> contour_pieces(const StudyMap& map, std::size_t columns, double level) {
  std::vector<QLineF> pieces;
  for (std::size_t row = 0; (row + 2) * columns <= map.cells.size(); ++row) {
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const CellSquare square = square_at(map, columns, column, row);
      if (square.possible) {
        add_pieces(square, level, pieces);
      }
    }
  }
  return pieces;
}

/// Places of the cells of a map.
struct StudyMapPicture::Place {
  QRectF plot;
  std::size_t columns = 1;
  std::size_t rows = 1;

  QSizeF cell() const {
    return {plot.width() / static_cast<double>(columns), plot.height() / static_cast<double>(rows)};
  }
  /// (0, 0): the centre of the first cell, which is in the lower left corner.
  QPointF at(const QPointF& place) const {
    return {plot.left() + (place.x() + 0.5) * cell().width(),
            plot.bottom() - (place.y() + 0.5) * cell().height()};
  }
  QPointF middle(std::size_t i) const {
    return at(QPointF(static_cast<double>(i % columns), static_cast<double>(i / columns)));
  }
};

StudyMapPicture::StudyMapPicture(QString title, QString details, StudyMaps study, const QFont& font)
    : title_(std::move(title)),
      details_(std::move(details)),
      study_(std::move(study)),
      font_(font),
      times_(time_bounds(study_)),
      levels_(error_levels(study_)) {
  font_.setPixelSize(12);
}

QSize StudyMapPicture::natural_size(std::size_t maps) {
  return picture_size(maps, maps == 1 ? single_map : natural_map);
}

QSize StudyMapPicture::least_size(std::size_t maps) {
  return picture_size(maps, least_map);
}

void StudyMapPicture::paint(QPainter& painter, const QSize& size) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF(QPointF(), size), Qt::white);
  painter.setFont(font_);
  const double line = QFontMetricsF(font_).height();
  const QRectF inner = QRectF(QPointF(), size).adjusted(map_margin, map_margin - 4, -map_margin, -8);
  const QRectF head(inner.topLeft(), QSizeF(inner.width(), 2 * line));
  paint_title(painter, head, title_, details_);
  const QRectF legend(inner.left(), inner.bottom() - 2.6 * line, inner.width(), 2.6 * line);
  const auto across = static_cast<double>(columns_of_maps(study_.maps.size()));
  const auto down = static_cast<double>(rows_of_maps(study_.maps.size()));
  const double wide = (inner.width() - (across - 1) * map_gap) / across;
  const double high = (legend.top() - head.bottom()) / down;
  for (std::size_t i = 0; i < study_.maps.size(); ++i) {
    const auto column = static_cast<double>(i % columns_of_maps(study_.maps.size()));
    const auto row = static_cast<double>(i / columns_of_maps(study_.maps.size()));
    paint_map(painter, study_.maps[i],
              {inner.left() + column * (wide + map_gap), head.bottom() + row * high, wide, high});
  }
  paint_legend(painter, legend);
}

QColor StudyMapPicture::colour_of(double time) const {
  const auto part = std::ranges::upper_bound(times_.values, time) - times_.values.begin();
  const auto parts = static_cast<double>(times_.values.size() + 1);
  const Rgb rgb = map_colour((static_cast<double>(part) + 0.5) / parts);
  return QColor::fromRgbF(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]));
}

namespace {

/// A number that stays on one line with its unit.
QString unbroken(QString number) {
  return number.replace(QLatin1Char(' '), QChar(QChar::Nbsp));
}

}  // namespace

QString StudyMapPicture::best_text(const StudyMap& map) const {
  const QString bound =
      study_.within ? unbroken(significant_text(*study_.within, Dimension::error, 4)) : QString();
  const auto best = std::ranges::find_if(map.cells, &StudyMapCell::best);
  if (best == map.cells.end()) {
    const bool any = std::ranges::any_of(map.cells, &StudyMapCell::possible);
    return !any ? MapTexts::tr("no run is possible")
           : bound.isEmpty() || std::ranges::any_of(map.cells,
                                                    [&](const StudyMapCell& cell) {
                                                      return cell.possible && cell.error <= *study_.within;
                                                    })
               ? MapTexts::tr("the two settings make no difference")
               : MapTexts::tr("no run within %1").arg(bound);
  }
  const auto i = static_cast<std::size_t>(best - map.cells.begin());
  const std::size_t columns = study_.x.values.size();
  const auto value = [](const StudyMapAxis& axis, std::size_t at) {
    return unbroken(QStringLiteral("%1 %2")
                        .arg(axis_texts(axis.values)[static_cast<qsizetype>(at)], axis.unit)
                        .trimmed());
  };
  const QString found =
      (study_.actual ? MapTexts::tr("%1 at %2 and %3, actual contour error %4")
                     : MapTexts::tr("%1 at %2 and %3, contour error %4"))
          .arg(unbroken(clock_text(best->time)), value(study_.x, i % columns), value(study_.y, i / columns),
               unbroken(significant_text(best->error, Dimension::error, 3)));
  return bound.isEmpty() ? MapTexts::tr("recommended: %1").arg(found)
                         : MapTexts::tr("recommended within %1: %2").arg(bound, found);
}

void StudyMapPicture::paint_map(QPainter& painter, const StudyMap& map, const QRectF& area) const {
  const QFontMetricsF metrics(font_);
  const double line = metrics.height();
  QFont bold = font_;
  bold.setBold(true);
  painter.setPen(map_ink);
  painter.setFont(bold);
  painter.drawText(QRectF(area.left(), area.top(), area.width(), line), Qt::AlignLeft,
                   QFontMetricsF(bold).elidedText(map.name, Qt::ElideMiddle, area.width()));
  painter.setFont(font_);
  painter.drawText(QRectF(area.left(), area.top() + line + 1, area.width(), 2 * line),
                   Qt::AlignLeft | Qt::TextWordWrap, best_text(map));
  const double above = area.width() < metrics.horizontalAdvance(best_text(map)) ? 3 * line : 2 * line;
  painter.drawText(QRectF(area.left(), area.top() + above + 6, area.width(), line), Qt::AlignLeft,
                   with_unit(study_.y.title, study_.y.unit));
  const Place place{area.adjusted(beside_map, above + line + 12, -6, -(2 * line + 20)),
                    study_.x.values.size(), study_.y.values.size()};
  PlotGrid grid(painter, place.plot, {map_grid, map_grid, map_ink});
  const QStringList across = axis_texts(study_.x.values);
  for (std::size_t i = 0; i < place.columns; ++i) {
    grid.upright(place.middle(i).x(), across[static_cast<qsizetype>(i)]);
  }
  const QStringList up = axis_texts(study_.y.values);
  for (std::size_t i = 0; i < place.rows; ++i) {
    grid.level(place.middle(i * place.columns).y(), up[static_cast<qsizetype>(i)]);
  }
  painter.drawText(QRectF(place.plot.left(), place.plot.bottom() + 8 + line, place.plot.width(), line),
                   Qt::AlignCenter, with_unit(study_.x.title, study_.x.unit));
  paint_cells(painter, map, place);
  paint_contours(painter, map, place);
  paint_times(painter, map, place);
}

void StudyMapPicture::paint_cells(QPainter& painter, const StudyMap& map, const Place& place) const {
  painter.setRenderHint(QPainter::Antialiasing, false);
  const QPointF half(place.cell().width() / 2, place.cell().height() / 2);
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const StudyMapCell& cell = map.cells[i];
    const QRectF area(place.middle(i) - half, place.middle(i) + half);
    painter.fillRect(area, cell.possible ? QBrush(colour_of(cell.time)) : QBrush(Qt::white));
    if (!cell.possible) {
      painter.fillRect(area, QBrush(impossible_ink, Qt::BDiagPattern));
    } else if (cell.lines_not_run > 0) {
      painter.fillRect(area, QBrush(QColor(255, 255, 255, 0xa0), Qt::FDiagPattern));
    }
  }
  painter.setRenderHint(QPainter::Antialiasing);
}

void StudyMapPicture::paint_contours(QPainter& painter, const StudyMap& map, const Place& place) const {
  const QFontMetricsF metrics(font_);
  std::vector<QRectF> taken;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const QSizeF size(metrics.horizontalAdvance(clock_text(map.cells[i].time)) + 6, metrics.height() + 4);
    taken.emplace_back(place.middle(i) - QPointF(size.width() / 2, size.height() / 2), size);
  }
  std::vector<std::pair<QRectF, QString>> labels;
  const auto draw = [&](double level, bool is_bound) {
    const QString text = QLocale().toString(in_shown_unit(level, Dimension::error), 'g', 4);
    const QSizeF size(metrics.horizontalAdvance(text) + 4, metrics.height() - 2);
    std::optional<QRectF> best;
    std::ptrdiff_t least = std::numeric_limits<std::ptrdiff_t>::max();
    for (const QLineF& piece : contour_pieces(map, place.columns, level)) {
      const QLineF line(place.at(piece.p1()), place.at(piece.p2()));
      draw_rimmed(painter, line, contour_pen(is_bound));
      const QRectF label(line.center() - QPointF(size.width() / 2, size.height() / 2), size);
      const auto faults =
          std::ranges::count_if(taken, [&](const QRectF& other) { return other.intersects(label); });
      if (faults < least) {
        least = faults;
        best = label;
      }
    }
    if (best) {
      taken.push_back(*best);
      labels.emplace_back(*best, text);
    }
  };
  for (const double level : levels_) {
    draw(level, false);
  }
  if (study_.within) {
    draw(*study_.within, true);
  }
  for (const auto& [label, text] : labels) {
    painter.fillRect(label, QColor(255, 255, 255, 215));
    painter.setPen(map_ink);
    painter.drawText(label, Qt::AlignCenter | Qt::TextDontClip, text);
  }
}

void StudyMapPicture::paint_times(QPainter& painter, const StudyMap& map, const Place& place) const {
  const QFontMetricsF metrics(font_);
  constexpr double room = 8;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const StudyMapCell& cell = map.cells[i];
    const QString text = clock_text(cell.time);
    QSizeF size(metrics.horizontalAdvance(text) + room, metrics.height() + 2);
    const bool fits = size.width() <= place.cell().width() && size.height() <= place.cell().height();
    if (!fits) {
      size = QSizeF(room, room);
    }
    const QRectF around(place.middle(i) - QPointF(size.width() / 2, size.height() / 2), size);
    if (fits && cell.possible) {
      if (cell.lines_not_run == 0) {
        painter.fillRect(around, colour_of(cell.time));  // keeps lines of the error off the time
      }
      painter.setPen(text_on(colour_of(cell.time)));
      painter.drawText(around, Qt::AlignCenter, text);
    }
    if (cell.best) {
      draw_ring(painter, around.adjusted(-4, -2, 4, 2));
    }
  }
}

double StudyMapPicture::paint_scale(QPainter& painter, const QRectF& area) const {
  const QFontMetricsF metrics(font_);
  const double line = metrics.height();
  const QString title = time_scale_title(MapTexts::tr("Cycle time"), times_);
  painter.setPen(map_ink);
  painter.drawText(QRectF(area.left(), area.top(), area.width(), line), Qt::AlignLeft, title);
  constexpr double part = 46;
  constexpr double height = 10;
  const double left = area.left() + metrics.horizontalAdvance(title) + 12;
  const double top = area.top() + (line - height) / 2;
  if (times_.values.empty()) {
    return left;
  }
  for (std::size_t i = 0; i <= times_.values.size(); ++i) {
    const double shift = i == 0 ? -times_.step / 2 : times_.step / 2;
    const QRectF piece(left + part * static_cast<double>(i), top, part, height);
    painter.fillRect(piece, colour_of(times_.values[i == 0 ? 0 : i - 1] + shift));
  }
  QRectF last;
  for (std::size_t i = 0; i < times_.values.size(); ++i) {
    const double x = left + part * static_cast<double>(i + 1);
    const QString text = time_tick_text(times_, i);
    const QRectF label(x - metrics.horizontalAdvance(text) / 2 - 2, area.top() + line,
                       metrics.horizontalAdvance(text) + 4, line);
    painter.setPen(map_ink);
    painter.drawLine(QPointF(x, top + height), QPointF(x, top + height + 3));
    if (!label.intersects(last)) {
      painter.drawText(label, Qt::AlignCenter, text);
      last = label;
    }
  }
  return left + part * static_cast<double>(times_.values.size() + 1);
}

void StudyMapPicture::paint_legend(QPainter& painter, const QRectF& area) const {
  const QFontMetricsF metrics(font_);
  constexpr double sample = 26;
  constexpr double gap = 22;
  double left = paint_scale(painter, area) + gap;
  const double middle = area.top() + metrics.height() / 2;
  const auto entry = [&](const QString& text, const auto& draw) {
    draw(QRectF(left, middle - 5, sample, 10));
    painter.setPen(map_ink);
    painter.drawText(QRectF(left + sample + 5, area.top(), area.right() - left, metrics.height()),
                     Qt::AlignLeft, text);
    left += sample + 5 + metrics.horizontalAdvance(text) + gap;
  };
  const auto line = [&](bool is_bound) {
    return [&painter, is_bound](const QRectF& at) {
      draw_rimmed(painter, QLineF(at.left(), at.center().y(), at.right(), at.center().y()),
                  contour_pen(is_bound));
    };
  };
  if (!levels_.empty()) {
    entry(with_unit_of(study_.actual ? MapTexts::tr("actual contour error") : MapTexts::tr("contour error"),
                       Dimension::error),
          line(false));
  }
  if (study_.within && is_crossed(study_, *study_.within)) {
    entry(MapTexts::tr("bound"), line(true));
  }
  const auto any = [&](const auto& is) {
    return std::ranges::any_of(study_.maps,
                               [&](const StudyMap& map) { return std::ranges::any_of(map.cells, is); });
  };
  if (any(&StudyMapCell::best)) {
    entry(MapTexts::tr("recommended"),
          [&](const QRectF& at) { draw_ring(painter, at.adjusted(1, 0, -1, 0)); });
  }
  if (any([](const StudyMapCell& cell) { return !cell.possible; })) {
    entry(MapTexts::tr("not possible"),
          [&](const QRectF& at) { painter.fillRect(at, QBrush(impossible_ink, Qt::BDiagPattern)); });
  }
  if (any([](const StudyMapCell& cell) { return cell.lines_not_run > 0; })) {
    entry(MapTexts::tr("without refused lines"), [&](const QRectF& at) {
      painter.fillRect(at, impossible_ink);
      painter.fillRect(at, QBrush(QColor(255, 255, 255, 0xa0), Qt::FDiagPattern));
    });
  }
}

}  // namespace feedscope::ui
