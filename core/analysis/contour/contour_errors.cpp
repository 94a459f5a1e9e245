#include "core/analysis/contour/contour_errors.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/contour/contour_histogram.h"
#include "core/analysis/contour/worst_places.h"

namespace feedscope {
namespace {

/// Corners of a path with plain corners, one by one: in closed form unless another pass is as near as the two
/// legs of the corner.
class PlainCorners {
 public:
  PlainCorners(const Trajectory& trajectory, ContourSearch& search)
      : path_(trajectory.path()), search_(search) {}

  /// First corner whose element is `element` or later.
  std::size_t first_from(std::uint32_t element) const {
    std::size_t first = 0;
    std::size_t last = path_.corner_count();
    while (first < last) {
      const std::size_t middle = (first + last) / 2;
      (path_.corner_element(middle) < element ? first = middle + 1 : last = middle);
    }
    return first;
  }

  std::uint32_t element(std::size_t corner) const { return path_.corner_element(corner); }

  /// Largest distance of a corner from its legs.
  double error_from_legs(std::size_t corner) const {
    const Corner laid = path_.corner(corner);
    return laid.epsilon * std::cos(laid.turn / 2);
  }

  /// Farthest place of a corner, in its middle unless another pass is nearer there; `left`: upper bound for
  /// all of its places.
  ContourNode farthest(std::size_t corner, double& left) const {
    ContourNode best = node(corner, 0.5);
    left = best.error;
    if (best.error < error_from_legs(corner) - ContourSearch::precision) {
      std::vector<ContourSpan> spans;
      search_.corner_spans(path_.corner_element(corner), spans);
      for (const ContourSpan& span : spans) {
        best = span.to.error > best.error ? span.to : best;
      }
      left = search_.largest_in(spans, best);
    }
    return best;
  }

  /// Node at `share` of the corner's parameter, or of its length.
  ContourNode node(std::size_t corner, double share) const {
    const std::uint32_t element = path_.corner_element(corner);
    const bool is_blend = path_.kind(element) == ElementKind::blend;
    return search_.node({element, is_blend ? share : share * path_.length(element)});
  }

 private:
  const BlendedPath& path_;
  ContourSearch& search_;
};

bool is_rapid(const Toolpath& path, std::size_t i) {
  return i >= path.segments.size() || path.segments[i].rapid;
}

/// Whether `place` on programmed segment `i` belongs only to rapids: that segment and the one at its nearer
/// end.
bool is_in_rapids(const Toolpath& path, std::size_t i, const Vec3& place) {
  if (!is_rapid(path, i)) {
    return false;
  }
  const bool at_start =
      (place - path.start_of(i)).squaredNorm() < (place - path.segments[i].end).squaredNorm();
  return at_start ? i == 0 || is_rapid(path, i - 1) : is_rapid(path, i + 1);
}

class Analysis {
 public:
  Analysis(const Trajectory& trajectory, const ContourRequest& request, Progress* progress)
      : trajectory_(trajectory),
        request_(request),
        progress_(progress),
        first_(request.first_element),
        last_(std::min<std::uint32_t>(request.last_element,
                                      static_cast<std::uint32_t>(trajectory.path().size()))),
        search_(trajectory),
        corners_(trajectory, search_) {}

  ContourErrors run() {
    ContourErrors errors;
    if (first_ >= last_) {
      return errors;
    }
    WorstPlaces worst(search_, request_.places);
    if (search_.course().has_plain_corners()) {
      const std::size_t end = corners_.first_from(last_);
      for (std::size_t i = corners_.first_from(first_); i < end; ++i) {
        stop_if_cancelled(progress_);
        if (worst.takes(corners_.error_from_legs(i)) &&
            counts_corner(trajectory_.path().segment(corners_.element(i)))) {
          double left = 0;
          const ContourNode farthest = corners_.farthest(i, left);
          if (worst.takes(farthest.error)) {
            worst.add(farthest, left);
          }
        }
      }
    }
    search_.for_spans(first_, last_, progress_, [&](const ContourSpan& span) {
      if (counts(span.from) && counts(span.to)) {
        worst.visit(span);
      }
    });
    worst.finish(errors, trajectory_);
    if (request_.bins != ContourBins::none || request_.spread) {
      count_lengths(errors);
    }
    return errors;
  }

 private:
  bool counts(const ContourNode& node) const {
    return !request_.cutting_only || !is_in_rapids(programmed_path(trajectory_), node.foot.segment,
                                                   node.point.position - node.foot.offset);
  }
  bool counts_corner(std::size_t block) const {
    const Toolpath& path = programmed_path(trajectory_);
    return !request_.cutting_only || !is_rapid(path, block) || !is_rapid(path, block + 1);
  }

  bool counts_length(std::uint32_t element) const {
    return !request_.cutting_only || !trajectory_.is_rapid(element);
  }
  /// Counted length of the executed path [mm].
  double length_that_counts() const {
    const BlendedPath& path = trajectory_.path();
    if (!request_.cutting_only) {
      return path.s(last_) - path.s(first_);
    }
    double length = 0;
    for (std::uint32_t element = first_; element < last_; ++element) {
      length += counts_length(element) ? path.length(element) : 0;
    }
    return length;
  }

  void count_lengths(ContourErrors& errors) {
    HistogramCounter histogram(request_.bins, errors.largest);
    SpreadCounter spread(errors.largest);
    const bool sides = request_.bins == ContourBins::sides;
    double counted = 0;
    const auto count = [&](const ContourNode& from, const ContourNode& to) {
      const double length = (to.point.position - from.point.position).norm();
      const double side_from = side_of(trajectory_, from);
      const double side_to = side_of(trajectory_, to);
      if (!counts_length(from.place.element)) {
        return;
      }
      counted += length;
      histogram.add(sides ? side_from : from.error, sides ? side_to : to.error, length);
      spread.add(from.error, to.error, side_from, side_to, length);
    };
    if (search_.course().has_plain_corners()) {
      count_corners(count);
    }
    ContourSearch again(trajectory_, search_.deviation());
    again.for_spans(first_, last_, progress_, [&](const ContourSpan& span) { count(span.from, span.to); });
    const double exact = std::max(length_that_counts() - counted, 0.0);
    histogram.add(0, 0, exact);
    spread.add(0, 0, 0, 0, exact);
    errors.histogram = histogram.result();
    if (request_.spread) {
      errors.spread = spread.result();
    }
  }

  template <typename Count>
  void count_corners(const Count& count) {
    constexpr int spans = 8;
    const std::size_t end = corners_.first_from(last_);
    ProgressSteps steps(progress_, end);
    for (std::size_t i = corners_.first_from(first_); i < end; ++i) {
      steps.at(i);
      ContourNode from = corners_.node(i, 0);
      for (int k = 1; k <= spans; ++k) {
        const ContourNode to = corners_.node(i, static_cast<double>(k) / spans);
        count(from, to);
        from = to;
      }
    }
  }

  const Trajectory& trajectory_;
  const ContourRequest& request_;
  Progress* progress_;
  std::uint32_t first_;
  std::uint32_t last_;
  ContourSearch search_;
  PlainCorners corners_;
};

}  // namespace

ContourErrors contour_errors(const Trajectory& trajectory, const ContourRequest& request,
                             Progress* progress) {
  return Analysis(trajectory, request, progress).run();
}

double cutting_contour_error(const Trajectory& trajectory, const ContourErrors& errors,
                             ContourRequest request, Progress* progress) {
  const Toolpath& path = programmed_path(trajectory);
  if (errors.worst.empty() ||
      !is_in_rapids(path, errors.worst.front().segment, errors.worst.front().programmed)) {
    return errors.largest;
  }
  request.places = 1;
  request.bins = ContourBins::none;
  request.spread = false;
  request.cutting_only = true;
  return contour_errors(trajectory, request, progress).largest;
}

double rounded_error(double error) {
  constexpr double steps = 1e9;  // a mm
  return std::round(error * steps) / steps;
}

}  // namespace feedscope
