#include "ui/annotations/annotation_picture.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <compare>
#include <optional>

#include "ui/annotations/annotation_text.h"

namespace feedscope::ui {
namespace {

constexpr double pixels_a_point = 96.0 / 72.0;
constexpr double padding = 5;        // of a label [pixels of scale 1]
constexpr double line_width = 1.5;   // the same
constexpr double region_width = 11;  // the same
constexpr double arrow_length = 11;  // the same
constexpr double tick_length = 12;   // the same
constexpr double label_gap = 3;      // between two [pixels of scale 1]
constexpr int region_spans = 1000;

QFont font_of(const PlacedAnnotation& placed) {
  QFont font = QGuiApplication::font();
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(placed.text_pixels))));
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

QPointF drawn_at(const AnnotatedView& view, double time) {
  const Pixel pixel = view.scene.pixel_of(view.scene.drawn_at(time));
  return {pixel[0], pixel[1]};
}

QSizeF label_size(const PlacedAnnotation& placed, double scale) {
  const QFontMetricsF metrics(font_of(placed));
  double width = 0;
  for (const QString& line : placed.lines) {
    width = std::max(width, metrics.horizontalAdvance(line));
  }
  const double height = metrics.lineSpacing() * static_cast<double>(placed.lines.size());
  return QSizeF(width, height) + QSizeF(2, 2) * padding * scale;
}

/// `label` moved into `room` by the smallest distance.
QRectF moved_into(QRectF label, const QRectF& room) {
  label.moveLeft(std::max(room.left(), std::min(label.left(), room.right() - label.width())));
  label.moveTop(std::max(room.top(), std::min(label.top(), room.bottom() - label.height())));
  return label;
}

/// The place on the border of `label` towards `place`; `place` itself within it.
QPointF border_towards(const QRectF& label, const QPointF& place) {
  const QPointF away = place - label.center();
  const double across = std::abs(away.x()) / std::max(label.width() / 2, 1e-9);
  const double along = std::abs(away.y()) / std::max(label.height() / 2, 1e-9);
  const double reach = std::max(across, along);
  return reach <= 1 ? place : label.center() + away / reach;
}

/// Line from a label to its reference point.
QLineF leader_of(const QRectF& label, const QPointF& place) {
  return {border_towards(label, place), place};
}

/// Whether a part of the line is in the rectangle, after Liang and Barsky.
bool crosses(const QLineF& line, const QRectF& rectangle) {
  double from = 0;
  double to = 1;
  const auto cut = [&](double step, double room) {
    if (step == 0) {
      return room >= 0;
    }
    (step < 0 ? from : to) = step < 0 ? std::max(from, room / step) : std::min(to, room / step);
    return from <= to;
  };
  return cut(-line.dx(), line.x1() - rectangle.left()) && cut(line.dx(), rectangle.right() - line.x1()) &&
         cut(-line.dy(), line.y1() - rectangle.top()) && cut(line.dy(), rectangle.bottom() - line.y1());
}

/// Distribution of the path over a picture, counted in cells.
class PathCover {
 public:
  PathCover(const QSizeF& size, double cell)
      : cell_(cell),
        columns_(static_cast<int>(size.width() / cell) + 2),
        rows_(static_cast<int>(size.height() / cell) + 2),
        sums_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

  void add(const QPointF& point) {
    const int column = static_cast<int>(std::floor(point.x() / cell_)) + 1;
    const int row = static_cast<int>(std::floor(point.y() / cell_)) + 1;
    if (column > 0 && column < columns_ && row > 0 && row < rows_) {
      at(column, row) = 1;
    }
  }
  /// Call after the last point: sums over all cells to the left and above.
  void finish() {
    for (int row = 1; row < rows_; ++row) {
      for (int column = 1; column < columns_; ++column) {
        at(column, row) += at(column - 1, row) + at(column, row - 1) - at(column - 1, row - 1);
      }
    }
  }
  /// Number of cells in a rectangle that contain the path.
  int in(const QRectF& rectangle) {
    const auto column = [&](double x) {
      return std::clamp(static_cast<int>(std::ceil(x / cell_)), 0, columns_ - 1);
    };
    const auto row = [&](double y) {
      return std::clamp(static_cast<int>(std::ceil(y / cell_)), 0, rows_ - 1);
    };
    const int left = std::max(0, column(rectangle.left()) - 1);
    const int top = std::max(0, row(rectangle.top()) - 1);
    const int right = column(rectangle.right());
    const int bottom = row(rectangle.bottom());
    return at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
  }
  double cell() const { return cell_; }

 private:
  int& at(int column, int row) {
    return sums_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                 static_cast<std::size_t>(column)];
  }

  double cell_;
  int columns_, rows_;
  std::vector<int> sums_;
};

/// Places labels one after the other.
class LabelPlacer {
 public:
  LabelPlacer(const QRectF& room, double scale, PathCover cover)
      : room_(room), gap_(label_gap * scale), cover_(std::move(cover)) {}

  /// Keeps labels and leaders off `rectangle`.
  void keep_free(const QRectF& rectangle) { taken_.append(rectangle); }

  /// Place to keep away from when a label must move.
  void avoid(const QPointF& place) { places_.append(place); }

  /// The nearest free place for a label of the place `middle`, off the path unless the user has moved it
  /// (`put`); if no place is free, the one that covers least.
  QRectF place(const QRectF& asked, const QPointF& middle, bool has_leader, bool put) {
    const QRectF wanted = moved_into(asked, room_);
    const auto leader = [&](const QRectF& label) {
      return has_leader ? std::optional(leader_of(label, middle)) : std::nullopt;
    };
    const bool free = covered_by(wanted, leader(wanted)) == 0 && (put || cover_.in(wanted) == 0);
    const QRectF found = free ? wanted : nearest_free(wanted, leader, put);
    taken_.append(found);
    if (const auto line = leader(found)) {
      leaders_.append(*line);
    }
    return found;
  }

 private:
  /// Area of placed labels that a label would cover; a leader that crosses a text counts as a whole label
  /// [pixels2].
  double covered_by(const QRectF& label, const std::optional<QLineF>& leader) const {
    const QRectF wide = label.adjusted(-gap_, -gap_, gap_, gap_);
    double area = 0;
    for (const QRectF& taken : taken_) {
      const QRectF both = taken & wide;
      area += both.width() * both.height();
      area += leader && crosses(*leader, taken) ? label.width() * label.height() : 0;
    }
    for (const QLineF& line : leaders_) {
      area += crosses(line, label) ? label.width() * label.height() : 0;
    }
    return area;
  }
  bool covers_place(const QRectF& label) const {
    return std::ranges::any_of(places_, [&](const QPointF& place) { return label.contains(place); });
  }

  template <class Leader>
  QRectF nearest_free(const QRectF& wanted, Leader leader, bool put) {
    constexpr double most_looks = 4000;
    constexpr double worth = 6;  // a covered cell of the path costs as much as a move by so many cell widths
    const QSizeF free = (room_.size() - wanted.size()).expandedTo(QSizeF(1, 1));
    const double step = std::max(2 * gap_, std::sqrt(free.width() * free.height() / most_looks));
    struct Candidate {
      double covered, distance;
      auto operator<=>(const Candidate&) const = default;
    };
    const auto distance_of = [&](const QRectF& moved) {
      return QLineF(moved.topLeft(), wanted.topLeft()).length();
    };
    const auto rated = [&](const QRectF& moved) {
      // Covering a place of the path costs as much as a move by the whole width.
      const double at_place = covers_place(moved) ? room_.width() : 0;
      const double on_path = put ? 0 : worth * cover_.cell() * cover_.in(moved);
      return Candidate{covered_by(moved, leader(moved)), distance_of(moved) + at_place + on_path};
    };
    QRectF best = wanted;
    Candidate least = rated(wanted);
    for (double y = 0; y < free.height() + step; y += step) {
      for (double x = 0; x < free.width() + step; x += step) {
        const QRectF moved = moved_into(QRectF(room_.topLeft() + QPointF(x, y), wanted.size()), room_);
        if (least.covered == 0 && distance_of(moved) >= least.distance) {
          continue;  // a free place is nearer
        }
        if (const Candidate candidate = rated(moved); candidate < least) {
          least = candidate;
          best = moved;
        }
      }
    }
    return best;
  }

  QRectF room_;
  double gap_;
  PathCover cover_;
  QList<QRectF> taken_;
  QList<QLineF> leaders_;
  QList<QPointF> places_;
};

QRectF room_of(const AnnotatedView& view) {
  return QRectF(QPointF(), view.size);
}

/// Factor on a label's distance from its place: the ratio of this picture's size to that of the picture in
/// which a person put it.
double spread_of(const Annotation& annotation, const AnnotatedView& view) {
  if (annotation.view.isEmpty()) {
    return 1;
  }
  const QSizeF now = view.size / view.scale;
  return std::min(now.width() / annotation.view.width(), now.height() / annotation.view.height());
}

PlacedAnnotation place(const Annotation& annotation, const AnnotatedView& view) {
  const double time = time_of(view.trajectory, annotation.place);
  const double until = has_two_places(annotation.kind) ? time_of(view.trajectory, annotation.until) : time;
  AnnotationValues values;
  values.at = view.trajectory.state(time);
  if (view.sources.actual) {
    values.actual = view.sources.actual->at(values.at);
  }
  if (view.sources.load) {
    values.load = LoadSampler(*view.sources.load).at(values.at);
  }
  values.contour_error = view.scene.contour_error_at(time);
  values.distance = (view.trajectory.state(until).position - values.at.position).norm();
  values.duration = std::abs(until - time);
  values.run = view.run;

  PlacedAnnotation placed;
  placed.id = annotation.id;
  placed.kind = annotation.kind;
  placed.colour = annotation.colour;
  placed.text_pixels = annotation.size * pixels_a_point * view.scale;
  placed.lines = with_values(annotation.text, values).split('\n');
  placed.anchor = drawn_at(view, time);
  placed.other = drawn_at(view, until);
  placed.middle = placed.anchor;
  if (annotation.kind == AnnotationKind::dimension) {
    placed.middle = (placed.anchor + placed.other) / 2;
  } else if (annotation.kind == AnnotationKind::region) {
    for (int i = 0; i <= region_spans; ++i) {
      placed.stretch.append(drawn_at(view, time + (until - time) * i / region_spans));
    }
    placed.middle = placed.stretch[region_spans / 2];
  }
  QRectF label(QPointF(), label_size(placed, view.scale));
  label.moveCenter(placed.middle + annotation.offset * view.scale * spread_of(annotation, view));
  placed.label = label;
  return placed;
}

bool is_in(const PlacedAnnotation& placed, const QRectF& room) {
  return room.contains(placed.anchor) || room.contains(placed.other) ||
         std::ranges::any_of(placed.stretch, [&](const QPointF& point) { return room.contains(point); });
}

struct Tones {
  QColor text;
  QColor ground;
};

Tones tones_of(Background background) {
  constexpr int opacity = 235;
  return background == Background::light ? Tones{QColor(0x20, 0x20, 0x20), QColor(255, 255, 255, opacity)}
                                         : Tones{QColor(0xf0, 0xf0, 0xf0), QColor(0x24, 0x28, 0x2d, opacity)};
}

void draw_arrow_head(QPainter& painter, const QPointF& from, const QPointF& tip, double scale) {
  const QLineF shaft(tip, from);
  if (shaft.length() < 1e-6) {
    return;
  }
  QLineF side = shaft;
  side.setLength(arrow_length * scale);
  constexpr double half_angle = 16;  // [degrees]
  QPolygonF head{tip};
  for (const double angle : {half_angle, -half_angle}) {
    QLineF edge = side;
    edge.setAngle(side.angle() + angle);
    head.append(edge.p2());
  }
  painter.setBrush(painter.pen().color());
  painter.drawPolygon(head);
}

void draw_dimension(QPainter& painter, const PlacedAnnotation& placed, double scale) {
  const QLineF line(placed.anchor, placed.other);
  painter.drawLine(line);
  if (line.length() < 1e-6) {
    return;
  }
  QLineF across = line.normalVector();
  across.setLength(tick_length * scale / 2);
  const QPointF half = across.p2() - across.p1();
  for (const QPointF& end : {placed.anchor, placed.other}) {
    painter.drawLine(end - half, end + half);
  }
}

void draw_region(QPainter& painter, const PlacedAnnotation& placed, double scale) {
  QColor marked = placed.colour;
  marked.setAlphaF(0.35F);
  painter.save();
  painter.setPen(QPen(marked, region_width * scale, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  QPainterPath path;
  path.addPolygon(placed.stretch);
  painter.drawPath(path);
  painter.restore();
}

void draw_label(QPainter& painter, const PlacedAnnotation& placed, const Tones& tones, bool selected,
                double scale) {
  const bool framed = placed.kind != AnnotationKind::text && placed.kind != AnnotationKind::arrow;
  QPen border(placed.colour, line_width * scale * (selected ? 2 : 1));
  if (!framed && !selected) {
    border = Qt::NoPen;
  } else if (!framed) {
    border.setStyle(Qt::DotLine);
  }
  painter.setPen(border);
  painter.setBrush(tones.ground);
  painter.drawRoundedRect(placed.label, 3 * scale, 3 * scale);
  painter.setPen(tones.text);
  painter.setFont(font_of(placed));
  const QRectF inner = placed.label.adjusted(padding * scale, padding * scale, 0, 0);
  const QFontMetricsF metrics(painter.font());
  for (qsizetype i = 0; i < placed.lines.size(); ++i) {
    const double base = inner.top() + metrics.ascent() + metrics.lineSpacing() * static_cast<double>(i);
    painter.drawText(QPointF(inner.left(), base), placed.lines[i]);
  }
}

/// Draws everything except the label.
void draw_marks(QPainter& painter, const PlacedAnnotation& placed, const Tones& tones, bool selected,
                double scale) {
  painter.setPen(QPen(placed.colour, line_width * scale));
  painter.setBrush(Qt::NoBrush);
  const QPointF end = border_towards(placed.label, placed.middle);
  switch (placed.kind) {
    case AnnotationKind::text:
      break;
    case AnnotationKind::arrow:
      painter.drawLine(end, placed.anchor);
      draw_arrow_head(painter, end, placed.anchor, scale);
      break;
    case AnnotationKind::dimension:
      draw_dimension(painter, placed, scale);
      painter.setPen(QPen(placed.colour, line_width * scale, Qt::DotLine));
      painter.drawLine(end, placed.middle);
      break;
    case AnnotationKind::region:
      draw_region(painter, placed, scale);
      painter.drawLine(end, placed.middle);
      break;
    case AnnotationKind::callout:
      painter.drawLine(end, placed.anchor);
      break;
  }
  if (placed.kind == AnnotationKind::callout || selected) {
    painter.setBrush(placed.colour);
    painter.setPen(QPen(tones.ground, scale));
    painter.drawEllipse(placed.anchor, 4 * scale, 4 * scale);
    if (selected && has_two_places(placed.kind)) {
      painter.drawEllipse(placed.other, 4 * scale, 4 * scale);
    }
  }
}

}  // namespace

std::vector<PlacedAnnotation> place_annotations(std::span<const Annotation> annotations,
                                                const AnnotatedView& view) {
  std::vector<PlacedAnnotation> all;
  if (view.trajectory.pieces().empty()) {
    return all;
  }
  const QRectF room = room_of(view);
  constexpr double cell = 8;  // [pixels of scale 1]
  constexpr int path_samples = 1000;
  PathCover cover(view.size, cell * view.scale);
  for (int i = 0; i <= path_samples && !annotations.empty(); ++i) {
    cover.add(drawn_at(view, view.trajectory.duration() * i / path_samples));
  }
  cover.finish();
  LabelPlacer labels(room, view.scale, std::move(cover));
  for (const auto& [upper, lower] : view.scene.covered()) {
    labels.keep_free(QRectF(QPointF(upper[0], upper[1]), QPointF(lower[0], lower[1])));
  }
  std::vector<bool> was_put;
  for (const Annotation& annotation : annotations) {
    PlacedAnnotation placed = place(annotation, view);
    if (is_in(placed, room)) {
      labels.avoid(placed.anchor);
      all.push_back(std::move(placed));
      was_put.push_back(!annotation.view.isEmpty());
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    PlacedAnnotation& placed = all[i];
    placed.label = labels.place(placed.label, placed.middle, placed.kind != AnnotationKind::text, was_put[i]);
  }
  return all;
}

QStringList annotation_texts(std::span<const Annotation> annotations, const AnnotatedView& view) {
  QStringList texts;
  for (const Annotation& annotation : annotations) {
    texts.append(place(annotation, view).lines.join('\n'));
  }
  return texts;
}

void draw_annotations(QPainter& painter, std::span<const PlacedAnnotation> annotations,
                      const AnnotatedView& view, int selected) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath room;
  room.addRect(room_of(view));
  if (std::ranges::count(annotations, AnnotationKind::region, &PlacedAnnotation::kind) > 0) {
    for (const auto& [upper, lower] : view.scene.covered()) {  // a wide stroke would hide their text
      QPainterPath text;
      text.addRect(QRectF(QPointF(upper[0], upper[1]), QPointF(lower[0], lower[1])));
      room -= text;
    }
  }
  painter.setClipPath(room, Qt::IntersectClip);
  const Tones tones = tones_of(view.background);
  const auto is_selected = [&](const PlacedAnnotation& placed) {
    return selected != 0 && placed.id == selected;
  };
  for (const PlacedAnnotation& placed : annotations) {
    draw_marks(painter, placed, tones, is_selected(placed), view.scale);
  }
  for (const PlacedAnnotation& placed : annotations) {
    draw_label(painter, placed, tones, is_selected(placed), view.scale);
  }
  painter.restore();
}

}  // namespace feedscope::ui
