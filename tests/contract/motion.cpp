#include "tests/contract/motion.h"

#include <algorithm>

namespace feedscope::contract {
namespace {

Place place_of(const Toolpath& toolpath, const BlendedPath& path, std::uint32_t element) {
  switch (path.kind(element)) {
    case ElementKind::blend:
    case ElementKind::connecting_arc:
      return Place::blend;
    case ElementKind::arc:
      return Place::arc;
    case ElementKind::curve:
      return Place::curve;
    case ElementKind::dwell:
      return Place::dwell;
    case ElementKind::line:
      return Place::line;
    case ElementKind::filtered:
    case ElementKind::fitted:
      break;
  }
  return toolpath.segments[path.segment(element)].kind == SegmentKind::arc ? Place::arc : Place::line;
}

}  // namespace

Motion::Motion(const Toolpath& toolpath, const Trajectory& run) : toolpath_(toolpath), run_(run) {
  const BlendedPath& path = run.path();
  for (PartWalk walk(run); !walk.done(); walk.next()) {
    const feedscope::Part& law = walk.part();
    parts_.push_back({laws_.size(), law.time, law.duration, law.element, path.segment(law.element),
                      place_of(toolpath, path, law.element)});
    laws_.push_back(law);
  }
}

State Motion::at(const Part& part, double share) const {
  return PartMotion(run_, laws_[part.number], &filters_).state(share * part.duration);
}

Kinematics Motion::kinematics(const Part& part, double share) const {
  return PartMotion(run_, laws_[part.number], &filters_).kinematics(share * part.duration);
}

Vec3 Motion::position(double time) const {
  const auto after =
      std::partition_point(parts_.begin(), parts_.end(), [&](const Part& part) { return part.time <= time; });
  const std::size_t number =
      after == parts_.begin() ? 0 : static_cast<std::size_t>(after - parts_.begin()) - 1;
  return PartMotion(run_, laws_[number], &filters_).kinematics(time - parts_[number].time).position;
}

std::size_t Motion::first_part_of(std::size_t segment) const {
  const auto found = std::partition_point(parts_.begin(), parts_.end(),
                                          [&](const Part& part) { return part.segment < segment; });
  return static_cast<std::size_t>(found - parts_.begin());
}

double Motion::element_start(const Part& part) const {
  return run_.path().s(part.element);
}

double Motion::size(const Part& part) const {
  const ElementCurve curve = run_.path().curve(part.element);
  const double size = curve.start.norm() + curve.end.norm() + curve.length;
  return curve.is_arc() ? size + curve.arc.radius : size;
}

double Motion::length(const Part& part) const {
  return run_.path().length(part.element);
}

bool Motion::lags() const {
  const BlendedPath& path = run_.path();
  for (std::size_t e = 0; e < path.size(); ++e) {
    if (path.kind(e) != ElementKind::dwell) {
      return path.kind(e) == ElementKind::fitted;
    }
  }
  return false;
}

const FilteredMotion* Motion::filtered(const Part& part) const {
  return run_.path().kind(part.element) == ElementKind::filtered ? &run_.motion_of(part.element) : nullptr;
}

double Motion::time_scale(const Part& part) const {
  const FilteredMotion* motion = filtered(part);
  return motion != nullptr ? std::min(part.duration, motion->filter_time()) : part.duration;
}

std::vector<double> Motion::law_borders(const Part& part) const {
  std::vector<double> borders{0};
  if (const FilteredMotion* motion = filtered(part)) {
    const double start = part.time - motion->start();
    const double least = 1e-9 * motion->filter_time();  // what rounding keeps apart is one place
    for (double t = start;;) {
      t = std::max(filters_.next_knot(motion->train(), t), t + least);
      const double share = (t - start) / part.duration;
      if (!(share < 1)) {
        break;
      }
      borders.push_back(share);
    }
  }
  if (run_.path().kind(part.element) == ElementKind::fitted) {
    const feedscope::Part& law = laws_[part.number];
    const auto course = run_.path().curve(part.element).course;
    const auto behind = [](double q, const CourseKnot& knot) { return q < knot.s; };
    for (auto knot = std::upper_bound(course.begin(), course.end(), law.q, behind); knot != course.end();
         ++knot) {
      const double time = time_to_reach({law.q, law.v, law.a, law.j}, knot->s, law.duration);
      if (!(time < law.duration)) {
        break;
      }
      borders.push_back(time / law.duration);
    }
  }
  borders.push_back(1);
  return borders;
}

double Motion::turn_rate(const Part& part) const {
  const FilteredMotion* motion = filtered(part);
  double rate = 0;
  for (std::size_t i = 0; motion != nullptr && i < motion->train().size(); ++i) {
    const PulseTrain& train = motion->train();
    if (train.segment(i).kind == SegmentKind::arc) {
      rate = std::max(rate, train.blocks[i].feed / train.arc(i).length_per_radian());
    }
  }
  return rate;
}

double Motion::velocity_rounding(const Part& part) const {
  return FilterWalk::velocity_rounding * commanded_speed(part);
}

double Motion::memory(const Part& part) const {
  const FilteredMotion* motion = filtered(part);
  return motion != nullptr ? motion->delay() : 0;
}

double Motion::commanded_speed(const Part& part) const {
  const FilteredMotion* motion = filtered(part);
  return motion != nullptr ? motion->train().largest_feed : 0;
}

bool same_bits(const Trajectory& a, const Trajectory& b) {
  const auto same_piece = [](const Piece& p, const Piece& q) {
    return p.time == q.time && p.q == q.q && p.v == q.v && p.a == q.a && p.j == q.j &&
           p.element == q.element && p.cause == q.cause && p.law == q.law && p.second == q.second;
  };
  bool same =
      a.duration() == b.duration() && a.path().size() == b.path().size() &&
      std::equal(a.pieces().begin(), a.pieces().end(), b.pieces().begin(), b.pieces().end(), same_piece);
  for (std::size_t e = 0; same && e < a.path().size(); ++e) {
    same = a.path().s(e) == b.path().s(e) && a.path().segment(e) == b.path().segment(e) &&
           a.path().kind(e) == b.path().kind(e);
  }
  return same;
}

}  // namespace feedscope::contract
