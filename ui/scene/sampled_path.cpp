#include "ui/scene/sampled_path.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/scene/path/sampler.h"
#include "ui/scene/path/shown_extent.h"

namespace feedscope::ui {

const SampledDeviations& AskedDeviations::at(std::span<const double> times) const {
  std::call_once(once_, [&] {
    found_ = find_(times);
    asked_.store(true);
  });
  return found_;
}

const SampledDeviations& SampledPath::found_deviations() const {
  static const SampledDeviations none;
  return deviations ? deviations->at(times) : none;
}

SampledPath sample_programmed(const Toolpath& toolpath, std::size_t max_points) {
  SampledPath path;
  if (toolpath.segments.empty()) {
    return path;
  }
  const auto spans_of = [&](const Segment& segment, double spacing) {
    const double wanted =
        segment.kind == SegmentKind::arc ? spans_of_arc(toolpath.arc_of(segment), segment.length) : 1.0;
    return spans(wanted, segment.length, spacing);
  };
  std::size_t wanted = 1;
  for (const Segment& segment : toolpath.segments) {
    wanted += spans_of(segment, 0);
  }
  const double spacing = spacing_for(wanted, max_points, toolpath.length());

  path.origin = local_origin(toolpath);
  path.zero_points = toolpath.zero_points;
  path.positions.reserve(std::min(wanted, max_points) + 1);
  path.kinds.reserve(std::min(wanted, max_points) + 1);
  Sampler sampler(path, spacing);
  std::optional<Vec3> end;  // of the last segment with a path
  bool gap = false;         // after it
  for (std::size_t i = 0; i < toolpath.segments.size(); ++i) {
    const Segment& segment = toolpath.segments[i];
    if (segment.kind == SegmentKind::dwell) {
      gap = gap || toolpath.is_gap(segment);
      continue;
    }
    if (gap && end) {
      Sampler(path, 0).add(*end, SpanKind::gap, 0);
    }
    gap = false;
    end = segment.end;
    const SpanKind kind = segment.rapid ? SpanKind::rapid : SpanKind::cut;
    const std::size_t count = spans_of(segment, spacing);
    const double span = segment.length / static_cast<double>(count);
    sampler.add(toolpath.start_of(i), kind, span);
    for (std::size_t k = 1; k < count; ++k) {
      const Arc& arc = toolpath.arc_of(segment);
      sampler.add(arc.at(span * static_cast<double>(k)).position, kind, span);
    }
  }
  if (end) {
    Sampler(path, 0).add(*end, SpanKind::cut, 0);
  }
  path.levels = levels_of(path);
  return path;
}

namespace {

constexpr std::size_t quick_points = 10'000;  // drawn in software in a hundredth of a second
constexpr double points_across = 16'000;      // along the largest extent, at the first level
constexpr double coarsest_points_across = 50;

/// The points of `level` without those closer than `spacing` [mm] to the previously kept one and to the next.
PathLevel thinned(const SampledPath& path, const PathLevel& level, double spacing) {
  PathLevel kept{spacing, 0, {}};
  const auto limit = static_cast<float>(spacing * spacing);
  for (std::size_t k = 0; k < level.size(); ++k) {
    const Eigen::Vector3f& here = path.positions[level[k]];
    const bool last = k + 1 == level.size();
    const bool at_gap =
        path.kinds[level[k]] == SpanKind::gap || (k > 0 && path.kinds[level[k - 1]] == SpanKind::gap);
    if (!last && !at_gap && k > 0 && (here - path.positions[kept.points.back()]).squaredNorm() < limit &&
        (path.positions[level[k + 1]] - here).squaredNorm() < limit) {
      continue;
    }
    kept.points.push_back(static_cast<std::uint32_t>(level[k]));
  }
  kept.count = kept.points.size();
  return kept;
}

}  // namespace

std::vector<PathLevel> levels_of(const SampledPath& path) {
  std::vector<PathLevel> levels{{0, path.size(), {}}};
  if (path.size() <= 2 * quick_points) {
    return levels;
  }
  const Bounds cut = cut_bounds(path);
  const Bounds& around = cut.empty() ? path.bounds : cut;
  const double extent = around.empty() ? 0.0 : (around.max - around.min).maxCoeff();
  if (!(extent > 0)) {
    return levels;
  }
  for (double across = points_across; across >= coarsest_points_across && levels.back().size() > quick_points;
       across /= 2) {
    PathLevel coarser = thinned(path, levels.back(), extent / across);
    if (2 * coarser.size() < levels.back().size()) {
      levels.push_back(std::move(coarser));
    }
  }
  return levels;
}

std::vector<SpanBox> boxes_of(const std::vector<Eigen::Vector3f>& positions) {
  std::vector<SpanBox> boxes;
  boxes.reserve(positions.size() / spans_of_box + 1);
  for (std::size_t first = 0; first < positions.size(); first += spans_of_box) {
    const std::size_t end = std::min(positions.size(), first + spans_of_box + 1);
    SpanBox box{positions[first], positions[first]};
    for (std::size_t i = first + 1; i < end; ++i) {
      box.low = box.low.cwiseMin(positions[i]);
      box.high = box.high.cwiseMax(positions[i]);
    }
    boxes.push_back(box);
  }
  return boxes;
}

double length_of(const SampledPath& path, SpanKind kind) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path.kinds[i] == kind) {
      length += static_cast<double>((path.positions[i + 1] - path.positions[i]).norm());
    }
  }
  return length;
}

}  // namespace feedscope::ui
