#include "core/models/optimal/path_cells.h"

#include <algorithm>
#include <cmath>

#include "core/blend/corner.h"
#include "core/blend/junction.h"

namespace feedscope {
namespace {

/// Largest turn of an arc's cell; a blend's cell, which takes much less time, may turn more [rad].
constexpr double arc_turn = 0.03;
constexpr double blend_turn = 0.06;
/// Largest relative change of curvature and speed by the parameter in a cell that turns by more than that.
constexpr double even_change = 0.2;
constexpr double slight_turn = 0.015;

/// Largest number of halvings of a blend's cell.
constexpr int deepest_cut = 44;

PathPoint point_of(const CurvePoint& at) {
  return {at.d1, at.d2, at.d3};
}

PathPoint point_of(const BlendShape::Point& at) {
  return {at.tangent, at.k * at.normal, at.dk_ds * at.normal - at.k * at.k * at.tangent};
}

/// Largest square of the speed at `curvature` [mm2/s2].
double square_limit(double curvature, const CellRule& rule) {
  return std::min(rule.speed * rule.speed, rule.acceleration.minCoeff() / curvature);
}

/// Number of cells of a curve for a change of the square of the speed, as a share of `limit`.
double cells_of_change(double length, double limit, const CellRule& rule) {
  constexpr double most = 16;
  const double change = 2 * rule.acceleration.minCoeff() * length / limit;
  return std::clamp(std::ceil(most * change), 1.0, most);
}

/// Least number of cells for a curve of `length` whose largest curvature vector is about `curvature` [1/mm].
int min_cells(double length, double curvature, const CellRule& rule) {
  constexpr double few = 2;
  constexpr double slight = 1e-3;
  const double acceleration = rule.acceleration.minCoeff();
  const double limit = square_limit(curvature, rule);
  double count = few;
  const double bend = 4 * curvature / length;  // change of the curvature by path length, on a blend
  if (curvature * limit > slight * acceleration ||
      bend * limit * std::sqrt(limit) > slight * rule.jerk.minCoeff()) {
    count = std::max(cells_of_change(length, limit, rule), static_cast<double>(rule.least));
  }
  return rule.fineness * static_cast<int>(count);
}

void append_arc(const Arc& arc, PathCell cell, const CellRule& rule, std::vector<PathCell>& cells) {
  const int count = std::max(min_cells(cell.length, arc.curvature(), rule),
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

/// A place of a curve that is cut by its own parameter.
struct CutPlace {
  PathPoint point;
  double k;      ///< curvature [1/mm]
  double sigma;  ///< path length by the parameter [mm]
};

/// Cuts a curve into cells, halving by a parameter from 0 to 1 until each turns little.
template <typename At>
class CurveCutter {
 public:
  /// `at(u)` gives a CutPlace; `cell`: the whole curve.
  CurveCutter(const At& at, int fineness, const PathCell& cell, std::vector<PathCell>& cells)
      : at_(at), fineness_(fineness), begin_(cell.offset), cell_(cell), cells_(cells) {}

  void cut(int count) {
    const std::size_t first = cells_.size();
    const double whole = cell_.length;
    CutPlace from = at_(0);
    for (int i = 0; i < count; ++i) {
      const double end = static_cast<double>(i + 1) / count;
      const CutPlace to = at_(end);
      cut(static_cast<double>(i) / count, end, from, to, 0);
      from = to;
    }
    const double scale = whole / reached_;  // Simpson's rule against the length of the path
    for (std::size_t i = first; i < cells_.size(); ++i) {
      cells_[i].length *= scale;
      cells_[i].offset = begin_ + cells_[i].offset * scale;
    }
  }

 private:
  void cut(double u0, double u1, const CutPlace& from, const CutPlace& to, int depth) {
    const double middle = (u0 + u1) / 2;
    const CutPlace at = at_(middle);
    if (depth < deepest_cut && !is_even(from, at, to)) {
      cut(u0, middle, from, at, depth + 1);
      cut(middle, u1, at, to, depth + 1);
      return;
    }
    cell_.length = (u1 - u0) * (from.sigma + 4 * at.sigma + to.sigma) / 6;
    cell_.offset = reached_;
    cell_.from = from.point;
    cell_.middle = at.point;
    cell_.to = to.point;
    reached_ += cell_.length;
    cells_.push_back(cell_);
  }

  /// True if it turns little from `from` to `to`, there and back as well, and about evenly where it turns at
  /// all.
  bool is_even(const CutPlace& from, const CutPlace& at, const CutPlace& to) const {
    const auto within = [](double a, double b) {
      return std::abs(a - b) <= even_change * std::max(std::abs(a), std::abs(b));
    };
    const Vec3 bulge = 4 * at.point.t - 2 * (from.point.t + to.point.t);
    const double turn = std::max((to.point.t - from.point.t).norm(), bulge.norm()) * fineness_;
    return turn <= slight_turn ||
           (turn <= blend_turn && within(from.k, to.k) && within(from.sigma, to.sigma));
  }

  const At& at_;
  int fineness_;
  double begin_;
  PathCell cell_;
  std::vector<PathCell>& cells_;
  double reached_ = 0;
};

void append_blend(const CubicBlend& blend, const PathCell& cell, const CellRule& rule,
                  std::vector<PathCell>& cells) {
  const Vec3 in = blend.corner - blend.start;
  const double transition = in.norm();
  const BlendShape shape(in / transition, (blend.end - blend.corner) / transition, transition, blend.alpha);
  const auto at = [&](double u) {
    const BlendShape::Point point = shape.at(u);
    return CutPlace{point_of(point), point.k, point.sigma};
  };
  const int count = min_cells(cell.length, shape.middle_curvature(), rule);
  CurveCutter(at, rule.fineness, cell, cells).cut(count);
}

void append_course(std::span<const CourseKnot> course, PathCell cell, const CellRule& rule,
                   std::vector<PathCell>& cells) {
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i + 1 < course.size(); ++i) {
    const CourseKnot& from = course[i];
    const CourseKnot& to = course[i + 1];
    const CourseSpan span(from, to);
    cell.offset = from.s - course.front().s;
    cell.length = span.length();
    cell.straight =
        from.curvature.isZero(0) && to.curvature.isZero(0) && (to.tangent - from.tangent).norm() <= rounding;
    if (cell.straight) {
      cell.from = cell.middle = cell.to = {(to.position - from.position).normalized()};
      cells.push_back(cell);
      continue;
    }
    const auto at = [&](double u) {
      const CurvePoint point = span.at(u * span.length());
      return CutPlace{point_of(point), point.d2.norm(), span.length()};
    };
    const double curvature = std::max(from.curvature.norm(), to.curvature.norm());
    const double count = cells_of_change(cell.length, square_limit(curvature, rule), rule);
    CurveCutter(at, rule.fineness, cell, cells).cut(rule.fineness * static_cast<int>(count));
  }
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
    case ElementKind::fitted:
    case ElementKind::curve:
      append_course(curve.course, cell, rule, cells);
      break;
    case ElementKind::dwell:
      break;
  }
}

bool all_straight(std::span<const PathCell> cells) {
  return std::all_of(cells.begin(), cells.end(), [](const PathCell& cell) { return cell.straight; });
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
  constexpr double digits = 1e-14;  // rounding of the coordinates in the direction of a short line
  const double rounding =
      digits * (1 + after.start.cwiseAbs().maxCoeff()) / std::min(before.length, after.length);
  const double allowed = (arc ? tangent_angle : straight_angle) + rounding;
  return turn_angle(before.at(before.length).d1, after.at(0).d1) > allowed;
}

}  // namespace feedscope
