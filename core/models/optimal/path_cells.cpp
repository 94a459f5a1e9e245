#include "core/models/optimal/path_cells.h"

#include <algorithm>
#include <cmath>

#include "core/blend/corner.h"
#include "core/blend/junction.h"

namespace feedscope {
namespace {

/// A cell of an arc turns by this at most; one of a blend, which is passed in a much shorter time, by more
/// [rad].
constexpr double arc_turn = 0.03;
constexpr double blend_turn = 0.06;
/// Curvature and speed by the parameter change by this share at most in a cell that turns by more than that.
constexpr double even_change = 0.2;
constexpr double slight_turn = 0.015;

/// A cell of a blend is halved this often at most.
constexpr int deepest_cut = 44;

PathPoint point_of(const CurvePoint& at) {
  return {at.d1, at.d2, at.d3};
}

PathPoint point_of(const BlendShape::Point& at) {
  return {at.tangent, at.k * at.normal, at.dk_ds * at.normal - at.k * at.k * at.tangent};
}

/// Least number of cells for a curve of `length` whose largest curvature vector is about `curvature` [1/mm].
int least_cells(double length, double curvature, const CellRule& rule) {
  constexpr double few = 2;
  constexpr double most = 16;
  constexpr double slight = 1e-3;
  const double acceleration = rule.acceleration.minCoeff();
  const double limit = std::min(rule.speed * rule.speed, acceleration / curvature);
  double count = few;
  const double bend = 4 * curvature / length;  // what the curvature changes by, by path length, on a blend
  if (curvature * limit > slight * acceleration ||
      bend * limit * std::sqrt(limit) > slight * rule.jerk.minCoeff()) {
    const double change = 2 * acceleration * length / limit;  // of v^2, over v^2
    count = std::clamp(std::ceil(most * change), most / 4, most);
  }
  return rule.fineness * static_cast<int>(count);
}

void append_arc(const Arc& arc, PathCell cell, const CellRule& rule, std::vector<PathCell>& cells) {
  const int count = std::max(least_cells(cell.length, arc.curvature(), rule),
                             static_cast<int>(std::ceil(arc.sweep * rule.fineness / arc_turn)));
  cell.length /= count;
  cell.to = point_of(arc.at(0));
  for (int i = 0; i < count; ++i) {
    cell.offset = i * cell.length;
    cell.from = cell.to;
    cell.middle = point_of(arc.at(cell.offset + cell.length / 2));
    cell.to = point_of(arc.at((i + 1) * cell.length));
    cells.push_back(cell);
  }
}

/// Cuts a blend into cells, halving by its own parameter until each turns little.
class BlendCutter {
 public:
  BlendCutter(const BlendShape& shape, const CellRule& rule, const PathCell& cell,
              std::vector<PathCell>& cells)
      : shape_(shape), rule_(rule), cell_(cell), cells_(cells) {}

  void cut(int count) {
    const std::size_t first = cells_.size();
    const double whole = cell_.length;
    BlendShape::Point from = shape_.at(0);
    for (int i = 0; i < count; ++i) {
      const double end = static_cast<double>(i + 1) / count;
      const BlendShape::Point to = shape_.at(end);
      cut(static_cast<double>(i) / count, end, from, to, 0);
      from = to;
    }
    const double scale = whole / reached_;  // Simpson's rule against the length that the path goes by
    for (std::size_t i = first; i < cells_.size(); ++i) {
      cells_[i].length *= scale;
      cells_[i].offset *= scale;
    }
  }

 private:
  void cut(double u0, double u1, const BlendShape::Point& from, const BlendShape::Point& to, int depth) {
    const double middle = (u0 + u1) / 2;
    const BlendShape::Point at = shape_.at(middle);
    if (depth < deepest_cut && !is_even(from, to)) {
      cut(u0, middle, from, at, depth + 1);
      cut(middle, u1, at, to, depth + 1);
      return;
    }
    cell_.length = (u1 - u0) * (from.sigma + 4 * at.sigma + to.sigma) / 6;
    cell_.offset = reached_;
    cell_.from = point_of(from);
    cell_.middle = point_of(at);
    cell_.to = point_of(to);
    reached_ += cell_.length;
    cells_.push_back(cell_);
  }

  /// Whether it turns little from `from` to `to`, and where it turns at all, about evenly.
  bool is_even(const BlendShape::Point& from, const BlendShape::Point& to) const {
    const auto within = [](double a, double b) {
      return std::abs(a - b) <= even_change * std::max(std::abs(a), std::abs(b));
    };
    const double turn = (to.tangent - from.tangent).norm() * rule_.fineness;
    return turn <= slight_turn ||
           (turn <= blend_turn && within(from.k, to.k) && within(from.sigma, to.sigma));
  }

  const BlendShape& shape_;
  const CellRule& rule_;
  PathCell cell_;
  std::vector<PathCell>& cells_;
  double reached_ = 0;
};

void append_blend(const CubicBlend& blend, const PathCell& cell, const CellRule& rule,
                  std::vector<PathCell>& cells) {
  const Vec3 in = blend.corner - blend.start;
  const double transition = in.norm();
  const BlendShape shape(in / transition, (blend.end - blend.corner) / transition, transition, blend.alpha);
  const int count = least_cells(cell.length, shape.middle_curvature(), rule);
  BlendCutter(shape, rule, cell, cells).cut(count);
}

}  // namespace

double law_length(const BlendedPath& path, std::uint32_t index) {
  constexpr double step = 0x1p-36;  // mm
  constexpr double too_short = 0x1p-24;
  const double length = path.length(index);
  return length < too_short ? length : std::round(length / step) * step;
}

void append_cells(const BlendedPath& path, std::uint32_t index, const CellRule& rule,
                  std::vector<PathCell>& cells) {
  const ElementCurve curve = path.curve(index);
  PathCell cell;
  cell.length = law_length(path, index);
  cell.element = index;
  switch (curve.kind) {
    case ElementKind::line:
    case ElementKind::filtered:
      cell.straight = true;
      cell.from = cell.middle = cell.to = point_of(curve.at(0));
      cells.push_back(cell);
      break;
    case ElementKind::arc:
    case ElementKind::connecting_arc:
      append_arc(curve.arc, cell, rule, cells);
      break;
    case ElementKind::blend:
      append_blend(curve.blend, cell, rule, cells);
      break;
    case ElementKind::dwell:
      break;
  }
}

bool is_stop(const BlendedPath& path, std::uint32_t index) {
  if (path.kind(index - 1) == ElementKind::dwell || path.kind(index) == ElementKind::dwell) {
    return true;
  }
  if (path.in_corner(index - 1) || path.in_corner(index)) {
    return false;
  }
  const Toolpath& toolpath = *path.programmed();
  if (path.segment(index - 1) != path.segment(index) &&
      toolpath.path_control_of(path.segment(index - 1)).mode == PathMode::exact_stop) {
    return true;
  }
  const ElementCurve before = path.curve(index - 1);
  const ElementCurve after = path.curve(index);
  const bool arc = before.kind == ElementKind::arc || after.kind == ElementKind::arc;
  constexpr double digits = 1e-14;  // what rounding of the coordinates does to the direction of a short line
  const double rounding =
      digits * (1 + after.start.cwiseAbs().maxCoeff()) / std::min(before.length, after.length);
  const double allowed = (arc ? tangent_angle : straight_angle) + rounding;
  return turn_angle(before.at(before.length).d1, after.at(0).d1) > allowed;
}

}  // namespace feedscope
