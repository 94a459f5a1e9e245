#include "core/analysis/agreement/programmed_course.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr double chord_error = 5e-4;  // [mm]

}  // namespace

ProgrammedCourse::ProgrammedCourse(const Toolpath& toolpath, const SeenAxes& seen) : seen_(seen) {
  starts_.reserve(toolpath.segments.size() + 1);
  lines_.reserve(toolpath.segments.size());
  add(toolpath.start, 0);
  const auto look_at = [&](const Vec3& place) {
    constexpr double noticed = 1e-3;  // [mm]
    for (std::size_t axis = 0; axis < moves_.size(); ++axis) {
      const auto i = static_cast<int>(axis);
      moves_[axis] = moves_[axis] || std::abs(place[i] - toolpath.start[i]) > noticed;
    }
  };
  for (std::size_t i = 0; i < toolpath.segments.size(); ++i) {
    const Segment& segment = toolpath.segments[i];
    starts_.push_back(length());
    lines_.push_back(segment.line);
    look_at(segment.end);
    if (segment.kind == SegmentKind::arc) {
      const Arc& arc = toolpath.arc_of(segment);
      const double step = 2 * std::sqrt(2 * chord_error * std::max(arc.radius, chord_error));
      const auto parts = static_cast<std::size_t>(std::ceil(std::max(1.0, segment.length / step)));
      for (std::size_t k = 1; k < parts; ++k) {
        const double from_start = segment.length * static_cast<double>(k) / static_cast<double>(parts);
        look_at(arc.at(from_start).position);
        add(arc.at(from_start).position, segment.length / static_cast<double>(parts));
      }
      add(segment.end, segment.length / static_cast<double>(parts));
    } else if (segment.kind == SegmentKind::line) {
      add(segment.end, segment.length);
    } else if (toolpath.is_gap(segment)) {
      add(segment.end, 0);
    }
  }
  starts_.push_back(length());
}

Vec3 ProgrammedCourse::visible(const Vec3& place) const {
  Vec3 seen = place;
  for (int axis = 0; axis < 3; ++axis) {
    seen[axis] = seen_[static_cast<std::size_t>(axis)] ? place[axis] : 0;
  }
  return seen;
}

void ProgrammedCourse::add(const Vec3& place, double length) {
  const Vec3 here = visible(place);
  const double step = points_.empty() ? 0 : (here - points_.back()).norm();
  s_.push_back(this->length() + length);
  seen_length_.push_back(seen_length_.empty() ? 0 : seen_length_.back() + step);
  points_.push_back(here);
  bounds_.add(here);
}

std::uint32_t ProgrammedCourse::segment_at(double s) const {
  const auto after = std::lower_bound(starts_.begin(), starts_.end(), s);
  const auto place = after == starts_.begin() ? 0 : after - starts_.begin() - 1;
  return static_cast<std::uint32_t>(
      std::min<std::ptrdiff_t>(place, std::max<std::ptrdiff_t>(0, std::ssize(starts_) - 2)));
}

}  // namespace feedscope
