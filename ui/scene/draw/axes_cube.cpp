#include "ui/scene/draw/axes_cube.h"

#include <algorithm>
#include <cmath>

namespace feedscope::ui {
namespace {

constexpr double edge_on = 0.03;

struct Side {
  int axis;
  int sign;
  StandardView view;
};
constexpr std::array sides{Side{2, 1, StandardView::top},    Side{2, -1, StandardView::bottom},
                           Side{1, -1, StandardView::front}, Side{1, 1, StandardView::back},
                           Side{0, -1, StandardView::left},  Side{0, 1, StandardView::right}};

Rgb between(const Rgb& a, const Rgb& b, double u) {
  return {std::lerp(a[0], b[0], u), std::lerp(a[1], b[1], u), std::lerp(a[2], b[2], u)};
}

}  // namespace

AxesCube::AxesCube(const Projection& projection, const Vec2& centre, double half)
    : right_(projection.right),
      up_(projection.up),
      towards_(projection.towards),
      centre_(centre),
      half_(half) {
  if (half <= 0) {
    return;
  }
  for (const Side& side : sides) {
    Vec3 out = Vec3::Zero();
    out[side.axis] = side.sign;
    Face face{side.view, {}, out.dot(towards_)};
    if (face.facing < edge_on) {
      continue;
    }
    Vec3 a = Vec3::Zero();
    a[(side.axis + 1) % 3] = 1;
    const Vec3 b = out.cross(a);
    face.corners = {at(out - a - b), at(out + a - b), at(out + a + b), at(out - a + b)};
    faces_.push_back(std::move(face));
  }
}

/// The edge along `axis` on the outline that is lowest on the screen, or leftmost if it is upright.
std::optional<AxesCube::Edge> AxesCube::outer_edge(int axis) const {
  std::optional<Edge> best;
  double best_rank = 0;
  for (const int b : {-1, 1}) {
    for (const int c : {-1, 1}) {
      const int other = (axis + 1) % 3;
      const int third = (axis + 2) % 3;
      if (b * towards_[other] * c * towards_[third] > 0) {
        continue;  // both faces visible, or both hidden
      }
      Vec3 end = Vec3::Zero();
      end[other] = b;
      end[third] = c;
      const Vec2 middle = at(end);
      end[axis] = 1;
      const Vec2 high = at(end);
      end[axis] = -1;
      const Vec2 low = at(end);
      const Vec2 along = high - low;
      const bool stands = std::abs(along.y()) > 0.9 * along.norm();
      const double rank = stands ? middle.x() : middle.y();
      if (along.norm() > edge_on * half_ && (!best || rank < best_rank - 0.5)) {
        best = Edge{low, high};
        best_rank = rank;
      }
    }
  }
  return best;
}

void AxesCube::draw_axis(Canvas& canvas, int axis, double scale, const SceneColours& colours) const {
  const auto edge = outer_edge(axis);
  if (!edge) {
    return;
  }
  const Vec2 along = edge->high - edge->low;
  const Rgb& colour = colours.axes[static_cast<std::size_t>(axis)];
  canvas.line(edge->low, edge->high, 2 * scale, colour);
  constexpr double readable_length = 0.5;  // of half an edge
  if (along.norm() < readable_length * half_) {
    return;
  }
  Vec2 out = Vec2(-along.y(), along.x()).normalized();
  if (out.dot((edge->low + edge->high) / 2 - centre_) < 0) {
    out = -out;
  }
  const TextStyle style{.size = 11 * scale, .colour = colour, .bold = true};
  canvas.text(std::string(1, coordinate_names[static_cast<std::size_t>(axis)]),
              edge->low + 0.8 * along + 7 * scale * out, style);
}

void AxesCube::draw(Canvas& canvas, double scale, const SceneColours& colours) const {
  for (const Face& face : faces_) {
    canvas.polygon(face.corners, between(colours.grid, colours.background, 0.8 * face.facing));
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      canvas.line(face.corners[i], face.corners[(i + 1) % face.corners.size()], scale, colours.frame);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    draw_axis(canvas, axis, scale, colours);
  }
}

std::optional<StandardView> AxesCube::view_at(const Vec2& place) const {
  for (const Face& face : faces_) {
    bool inside = true;
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const Vec2 edge = face.corners[(i + 1) % face.corners.size()] - face.corners[i];
      const Vec2 to = place - face.corners[i];
      inside = inside && edge.x() * to.y() - edge.y() * to.x() >= 0;
    }
    if (inside) {
      return face.view;
    }
  }
  return std::nullopt;
}

}  // namespace feedscope::ui
