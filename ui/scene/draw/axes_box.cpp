#include "ui/scene/draw/axes_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "core/base/ticks.h"
#include "core/base/units.h"
#include "ui/scene/camera/view_window.h"
#include "ui/units/unit_system.h"

namespace feedscope::ui {
namespace {

constexpr double axis_text_pixels = 13;
constexpr double tick_length = 5;
constexpr double label_gap = 9;       // from the edge
constexpr double label_spacing = 14;  // between labels side by side
constexpr double line_spacing = 8;    // between labels one above the other
constexpr double grid_spacing = 45;   // at least, between grid lines
constexpr double upright = 0.9;       // smallest vertical part of the direction of an upright edge
constexpr int enough_labels = 4;      // on a short edge, if there is room between them
constexpr double shortest_axis = 24;  // an edge that appears shorter has no labels
constexpr double end_on = 1e-6;
constexpr double shown_around = 1;  // of the window, on each side: labels and fits extend into it

double side(const Bounds& box, int axis, bool high) {
  return high ? box.max[axis] : box.min[axis];
}

/// One projected edge of the box.
struct Edge {
  Vec3 low, high;  ///< its ends
  Vec2 from, to;   ///< on the screen
  Vec2 outward;    ///< unit, away from the box

  double length() const { return (to - from).norm(); }
  Vec2 along() const { return (to - from).normalized(); }
};

class Layouter {
 public:
  Layouter(const SceneFrame& frame, const Projection& projection, double scale)
      : frame_(frame),
        projection_(projection),
        window_(projection, shown_around),
        scale_(scale),
        style_{.size = axis_text_pixels * scale} {}

  AxesLayout run() {
    std::array<std::optional<Edge>, 3> edges;
    for (int axis = 0; axis < 3; ++axis) {
      edges[axis] = labelled_edge(axis);
      if (edges[axis]) {
        ticks_[axis] = ticks_along(axis, *edges[axis]);
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool high : {false, true}) {
        if (facing(axis, high) < -end_on) {
          add_face(axis, high);
        }
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (edges[axis]) {
        add_labels(axis, *edges[axis]);
      }
    }
    return std::move(layout_);
  }

 private:
  /// How far a face of the box is turned towards the eye.
  double facing(int axis, bool high) const {
    Vec3 middle = Vec3::Zero();
    middle[axis] = side(frame_.box, axis, high);
    return (high ? 1 : -1) * projection_.towards_eye(middle)[axis];
  }

  static Vec3 point(int axis, double a, int other, double b, int third, double c) {
    Vec3 p;
    p[axis] = a;
    p[other] = b;
    p[third] = c;
    return p;
  }

  /// Visible range of a polygon or a line along an axis [mm].
  struct Range {
    double low, high;
  };
  std::optional<Range> in_view(std::span<const Vec3> corners, int axis) const {
    const std::vector<Vec3> seen = window_.clip(corners);
    if (seen.empty()) {
      return std::nullopt;
    }
    const auto along = [axis](const Vec3& p) { return p[axis]; };
    return Range{labelled(axis, along(std::ranges::min(seen, {}, along))),
                 labelled(axis, along(std::ranges::max(seen, {}, along)))};
  }

  void add_stroke(std::vector<AxesLayout::Stroke>& strokes, const Vec3& from, const Vec3& to) const {
    if (const std::vector<Vec3> seen = window_.clip(std::array{from, to}); !seen.empty()) {
      strokes.push_back(
          {projection_.to_display(seen.front()), projection_.to_display(seen[seen.size() / 2])});
    }
  }

  /// The outer edge along `axis` that is lowest on the screen, or leftmost if it is upright.
  std::optional<Edge> labelled_edge(int axis) const {
    const int other = (axis + 1) % 3;
    const int third = (axis + 2) % 3;
    const Vec2 centre = projection_.to_display(Vec3::Zero());
    std::optional<Edge> best;
    double best_rank = 0;
    for (const bool b : {false, true}) {
      for (const bool c : {false, true}) {
        const double facing_b = facing(other, b);
        const double facing_c = facing(third, c);
        if (facing_b * facing_c > end_on) {
          continue;  // both faces visible, or both hidden: an inner edge
        }
        Edge edge;
        const double at_b = side(frame_.box, other, b);
        const double at_c = side(frame_.box, third, c);
        edge.low = point(axis, frame_.box.min[axis], other, at_b, third, at_c);
        edge.high = point(axis, frame_.box.max[axis], other, at_b, third, at_c);
        edge.from = projection_.to_display(edge.low);
        edge.to = projection_.to_display(edge.high);
        if (edge.length() < shortest_axis * scale_) {
          continue;
        }
        const Vec2 along = edge.along();
        const bool stands = std::abs(along.y()) > upright;
        const Vec2 middle = (edge.from + edge.to) / 2;
        edge.outward = Vec2(-along.y(), along.x());
        const double away = edge.outward.dot(middle - centre);
        const bool outside =
            std::abs(away) > 1 ? away > 0 : (stands ? edge.outward.x() : edge.outward.y()) < 0;
        if (!outside) {
          edge.outward = -edge.outward;
        }
        const double rank = stands ? middle.x() : middle.y();
        if (!best || rank < best_rank - 0.5) {
          best = edge;
          best_rank = rank;
        }
      }
    }
    return best;
  }

  /// Length on the screen [pixels]; for a partly visible edge, at the scale of that part.
  double seen_length(const Edge& edge) const {
    const std::vector<Vec3> seen = window_.clip(std::array{edge.low, edge.high});
    const double part = seen.empty() ? 0 : (seen[seen.size() / 2] - seen.front()).norm();
    const double whole = (edge.high - edge.low).norm();
    if (!(part > 0) || part >= whole) {
      return edge.length();
    }
    const Vec2 from = projection_.to_display(seen.front());
    return (projection_.to_display(seen[seen.size() / 2]) - from).norm() / part * whole;
  }

  /// Suitable ticks of an edge, with the values in its visible range.
  Ticks ticks_along(int axis, const Edge& edge) const {
    const double from = labelled(axis, frame_.box.min[axis]);
    const double to = labelled(axis, frame_.box.max[axis]);
    const double length = seen_length(edge);
    const Range seen = in_view(std::array{edge.low, edge.high}, axis).value_or(Range{to, from});
    const Vec2 along = edge.along().cwiseAbs();
    double most = std::max<double>(enough_labels, std::floor(length / (grid_spacing * scale_)));
    while (true) {
      Ticks ticks = round_ticks_between(from, to, most, seen.low, seen.high);
      Vec2 largest = Vec2::Zero();
      for (const std::string& label : ticks.labels) {
        largest = largest.cwiseMax(Canvas::text_size(label, style_));
      }
      const Vec2 needed = largest + scale_ * Vec2(label_spacing, line_spacing);
      const double spacing =
          ticks.step / (frame_.unit * unit_.factor) * length / (frame_.box.max[axis] - frame_.box.min[axis]);
      const bool apart = spacing * along.x() >= needed.x() || spacing * along.y() >= needed.y();
      if (apart || ticks.count < 2) {
        return ticks;
      }
      most = std::min(most - 1, ticks.count);  // more would give the same step
    }
  }

  /// The label's number at a coordinate of the scene; tick_position() is the inverse.
  double labelled(int axis, double at) const { return frame_.to_mm(axis, at) * unit_.factor; }
  double tick_position(int axis, double value) const {
    return (value / unit_.factor - frame_.centre[axis]) / frame_.unit;
  }

  void add_face(int axis, bool high) {
    const double at = side(frame_.box, axis, high);
    for (int step = 1; step <= 2; ++step) {
      const int along = (axis + step) % 3;
      const int across = (axis + 3 - step) % 3;
      const double from = frame_.box.min[along];
      const double to = frame_.box.max[along];
      const auto line_at = [&](double c) {
        return std::array{point(along, from, across, c, axis, at), point(along, to, across, c, axis, at)};
      };
      add_grid(across, line_at);
      for (const bool far : {false, true}) {
        const auto line = line_at(side(frame_.box, across, far));
        add_stroke(layout_.frame, line[0], line[1]);
        layout_.outline.push_back(projection_.to_display(line[0]));
        layout_.outline.push_back(projection_.to_display(line[1]));
      }
    }
  }

  /// Lines on the visible part of a face, at the steps of `across`.
  template <class LineAt>
  void add_grid(int across, LineAt line_at) {
    const double low = frame_.box.min[across];
    const double high = frame_.box.max[across];
    const auto first = line_at(low);
    const auto last = line_at(high);
    const auto seen = in_view(std::array{first[0], first[1], last[1], last[0]}, across);
    const double step = ticks_[across].step;
    if (!seen || !(step > 0)) {
      return;
    }
    const double slack = 1e-9 * (high - low) * frame_.unit * unit_.factor;
    for (const double value : multiples(step, seen->low - slack, seen->high + slack)) {
      const auto line = line_at(tick_position(across, value));
      add_stroke(layout_.grid, line[0], line[1]);
    }
  }

  void add_text(std::string text, const Vec2& place, const TextStyle& style) {
    const Vec2 size = Canvas::text_size(text, style);
    const double c = std::abs(std::cos(style.angle));
    const double s = std::abs(std::sin(style.angle));
    const Vec2 half = Vec2(size.x() * c + size.y() * s, size.x() * s + size.y() * c) / 2;
    const Vec2 centre = place - Vec2(style.horizontal * half.x(), style.vertical * half.y());
    for (const Vec2& corner : {half, Vec2(-half), Vec2(half.x(), -half.y()), Vec2(-half.x(), half.y())}) {
      layout_.outline.emplace_back(centre + corner);
    }
    layout_.labels.push_back({std::move(text), place, style, {centre - half, centre + half}});
  }

  void add_labels(int axis, const Edge& edge) {
    TextStyle style = style_;
    constexpr double slant = 0.35;
    style.horizontal = edge.outward.x() > slant ? -1 : edge.outward.x() < -slant ? 1 : 0;
    style.vertical = edge.outward.y() > slant ? -1 : edge.outward.y() < -slant ? 1 : 0;
    double depth = 0;  // extent of the labels, away from the edge
    for (std::size_t i = 0; i < ticks_[axis].values.size(); ++i) {
      Vec3 at = edge.low;
      at[axis] = tick_position(axis, ticks_[axis].values[i]);
      const Vec2 p = projection_.to_display(at);
      layout_.frame.push_back({p, p + tick_length * scale_ * edge.outward});
      const Vec2 size = Canvas::text_size(ticks_[axis].labels[i], style_);
      depth = std::max(depth, size.dot(edge.outward.cwiseAbs()));
      add_text(ticks_[axis].labels[i], p + label_gap * scale_ * edge.outward, style);
    }
    TextStyle title = style_;
    title.bold = true;
    const Vec2 along = edge.along();
    title.angle = std::atan2(along.y(), along.x());
    if (title.angle > units::pi / 2 + 1e-6) {
      title.angle -= units::pi;
    } else if (title.angle < -units::pi / 2 + 1e-6) {
      title.angle += units::pi;
    }
    const double offset = (2 * label_gap + axis_text_pixels / 2) * scale_ + depth;
    add_text(
        std::string(1, coordinate_names[static_cast<std::size_t>(axis)]) + fmt::format(" ({})", unit_.text),
        (edge.from + edge.to) / 2 + offset * edge.outward, title);
  }

  const SceneFrame& frame_;
  const Projection& projection_;
  ViewWindow window_;
  double scale_;
  TextStyle style_;
  const ShownUnit& unit_ = shown(Dimension::length);
  std::array<Ticks, 3> ticks_;
  AxesLayout layout_;
};

}  // namespace

AxesLayout lay_out_axes(const SceneFrame& frame, const Projection& projection, double scale) {
  return Layouter(frame, projection, scale).run();
}

void draw(const AxesLayout& layout, double scale, const ScreenRectangle& window, const SceneColours& colours,
          const SceneTexts& texts, Canvas& canvas) {
  for (const auto& stroke : layout.grid) {
    canvas.line(stroke.from, stroke.to, scale, colours.grid);
  }
  for (const auto& stroke : layout.frame) {
    canvas.line(stroke.from, stroke.to, scale, colours.frame);
  }
  for (const auto& label : layout.labels) {
    if (window.contains(label.box)) {
      TextStyle style = label.style;
      style.colour = colours.text;
      canvas.text(texts.localised(label.text), label.place, style);
    }
  }
}

}  // namespace feedscope::ui
