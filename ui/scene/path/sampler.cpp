#include "ui/scene/path/sampler.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace feedscope::ui {
namespace {

constexpr double arc_step = units::pi / 60;  // [rad]

}  // namespace

bool Sampler::add(const Vec3& position, SpanKind kind, double span) {
  path_.bounds.add(position);
  const Eigen::Vector3f offset = (position - path_.origin).cast<float>();
  if (span < spacing_ && !path_.positions.empty() &&
      static_cast<double>((offset - path_.positions.back()).norm()) < spacing_) {
    return false;
  }
  path_.positions.push_back(offset);
  path_.kinds.push_back(kind);
  return true;
}

std::shared_ptr<const AskedDeviations> known_shifts(std::vector<StoredVector> shifts) {
  auto found = std::make_shared<SampledDeviations>();
  found->shifts = std::move(shifts);
  return std::make_shared<const AskedDeviations>(
      [found](std::span<const double>) { return std::move(*found); });
}

Vec3 local_origin(const Toolpath& toolpath) {
  Bounds cut;
  Bounds all;
  for (std::size_t i = 0; i < toolpath.segments.size(); ++i) {
    const Segment& segment = toolpath.segments[i];
    const bool cuts = segment.kind != SegmentKind::dwell && !segment.rapid;
    for (const Vec3& end : {toolpath.start_of(i), segment.end}) {
      all.add(end);
      if (cuts) {
        cut.add(end);
      }
    }
  }
  const Bounds& around = cut.empty() ? all : cut;
  return around.empty() ? toolpath.start : Vec3((around.min + around.max) / 2);
}

std::size_t spans(double wanted, double length, double spacing) {
  const double possible = spacing > 0 ? std::ceil(length / spacing) : wanted;
  return static_cast<std::size_t>(std::max(1.0, std::ceil(std::min(wanted, possible))));
}

double spans_of_arc(const Arc& arc, double length) {
  return length / arc.length_per_radian() / arc_step;
}

double spacing_for(std::size_t wanted, std::size_t max_points, double length) {
  return wanted <= max_points ? 0.0 : length / static_cast<double>(max_points);
}

}  // namespace feedscope::ui
