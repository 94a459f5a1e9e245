#include "core/analysis/difference/run_difference.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "core/analysis/difference/course_walk.h"
#include "core/analysis/difference/nearest_place.h"
#include "core/base/parallel.h"

namespace feedscope {
namespace {

void check(const Trajectory& run, const Trajectory& reference) {
  if (run.pieces().empty() || reference.pieces().empty()) {
    throw std::invalid_argument("the runs cannot be compared place by place: one of them has no motion");
  }
  const std::size_t segments = run.path().programmed()->segments.size();
  if (segments != reference.path().programmed()->segments.size()) {
    throw std::invalid_argument("the runs cannot be compared place by place: they are of different programs");
  }
}

constexpr std::size_t places_a_chunk = 8192;  // compared by one thread; independent of the number of threads
constexpr double share_of_courses = 0.4;      // of the time of a comparison

/// The piece before that at `time`, so that the earlier part is found at a border.
std::size_t piece_before(const Trajectory& trajectory, double time) {
  const std::vector<Piece>& pieces = trajectory.pieces();
  const auto after = std::ranges::lower_bound(pieces, time, {}, &Piece::time);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - pieces.begin() - 2));
}

/// The parts of a run at times in order, starting with `from`.
class PartFinder {
 public:
  PartFinder(const Trajectory& trajectory, double from)
      : trajectory_(trajectory), walk_(trajectory, piece_before(trajectory, from)), part_(walk_.part()) {}

  /// The part at `time`; the earlier one at a border.
  const Part& at(double time) {
    while (time > part_.time + part_.duration) {
      walk_.next();
      if (walk_.done()) {
        break;
      }
      part_ = walk_.part();
    }
    return part_;
  }
  double tau(double time) const { return std::clamp(time - part_.time, 0.0, part_.duration); }
  Vec3 position(double time) {
    at(time);
    return PartMotion(trajectory_, part_, &filters_).kinematics(tau(time)).position;
  }

 private:
  const Trajectory& trajectory_;
  PartWalk walk_;
  Part part_;
  FilterWalk filters_;
};

/// Two runs at the same places, in order.
class TwoCourses {
 public:
  TwoCourses(const Trajectory& run, const Trajectory& reference)
      : lengths_(lengths_before(*run.path().programmed())),
        run_(run, lengths_),
        reference_(reference, lengths_),
        end_(run.duration()),
        reference_end_(reference.duration()) {}

  /// Moves to `time` of the run.
  void go_to(double time) {
    while (time > run_.span().end_time() && run_.next()) {
    }
    const ProgressSpan& here = run_.span();
    const double tau = std::clamp(time - here.time, 0.0, here.duration);
    const double offset = here.offset_at(tau);
    place_ = here.begin + offset;
    while ((reference_.span().end < place_ ||
            (reference_.span().end <= place_ && reference_.span().segment < here.segment)) &&
           reference_.next()) {
    }
    const ProgressSpan& there = reference_.span();
    reference_time_ = there.time;
    if (here.dwell && there.dwell && here.segment == there.segment) {
      reference_time_ += here.duration > 0 ? tau / here.duration * there.duration : there.duration;
    } else if (here.same_law(there)) {
      reference_time_ += tau;
    } else {
      reference_time_ += there.tau_at(here.begin == there.begin ? offset : place_ - there.begin);
    }
    if (time >= end_) {  // both end there; at rest a place hardly determines the time
      reference_time_ = reference_end_;
    }
  }
  double place() const { return place_; }  ///< programmed path length [mm]
  double reference_time() const { return reference_time_; }

 private:
  std::vector<double> lengths_;
  CourseWalk run_;
  CourseWalk reference_;
  double end_;            ///< of the run [s]
  double reference_end_;  ///< [s]
  double place_ = 0;
  double reference_time_ = 0;
};

/// Time lost per length on the stretches around each place.
std::vector<float> paces(const std::vector<double>& lost, const std::vector<double>& places) {
  constexpr double a_jump = 1e-6;  // shorter stretches contain only rounding [mm]
  std::vector<float> pace(lost.size());
  const auto has_length = [&](std::size_t from) { return places[from + 1] - places[from] > a_jump; };
  for (std::size_t i = 0; i < lost.size(); ++i) {
    const std::size_t from = i > 0 && has_length(i - 1) ? i - 1 : i;
    const std::size_t to = i + 1 < lost.size() && has_length(i) ? i + 1 : i;
    if (to > from) {
      pace[i] = static_cast<float>((lost[to] - lost[from]) / (places[to] - places[from]));
    }
  }
  return pace;
}

/// Distances from the run at `times` to the path of the reference, which is at the same places at `then` [s].
/// Reports the remaining share of `progress`.
std::vector<float> distances(const Trajectory& run, const Trajectory& reference,
                             std::span<const double> times, std::span<const double> then,
                             Progress& progress) {
  std::vector<float> distances(times.size());
  const std::size_t chunks = (times.size() + places_a_chunk - 1) / places_a_chunk;
  std::atomic<std::size_t> done{0};
  in_parallel(chunks, [&](std::size_t chunk) {
    const std::size_t first = chunk * places_a_chunk;
    const std::size_t end = std::min(times.size(), first + places_a_chunk);
    PartFinder run_parts(run, std::clamp(times[first], 0.0, run.duration()));
    PartFinder reference_parts(reference, then[first]);
    NearestPlace nearest(reference);
    for (std::size_t i = first; i < end; ++i) {
      const Vec3 place = run_parts.position(std::clamp(times[i], 0.0, run.duration()));
      const Part& part = reference_parts.at(then[i]);
      distances[i] = static_cast<float>(nearest.distance(place, part, reference_parts.tau(then[i])));
    }
    const double share = static_cast<double>(++done) / static_cast<double>(chunks);
    progress.report(share_of_courses + (1 - share_of_courses) * share);
  });
  progress.report(1);
  return distances;
}

}  // namespace

std::vector<double> times_at_places(const Trajectory& run, const Trajectory& other,
                                    std::span<const double> times) {
  check(run, other);
  TwoCourses courses(run, other);
  std::vector<double> there;
  there.reserve(times.size());
  for (const double time : times) {
    courses.go_to(std::clamp(time, 0.0, run.duration()));
    there.push_back(courses.reference_time());
  }
  return there;
}

RunDifference compare_places(const Trajectory& run, const Trajectory& reference,
                             std::span<const double> times, Progress* progress) {
  check(run, reference);
  RunDifference difference;
  difference.lost.reserve(times.size());
  difference.reference_time.reserve(times.size());
  std::vector<double> places;
  places.reserve(times.size());
  Progress unwatched;
  Progress& watched = progress != nullptr ? *progress : unwatched;
  TwoCourses courses(run, reference);
  ProgressSteps steps(&watched,
                      static_cast<std::size_t>(static_cast<double>(times.size()) / share_of_courses));
  for (const double asked : times) {
    const double time = std::clamp(asked, 0.0, run.duration());
    courses.go_to(time);
    places.push_back(courses.place());
    difference.reference_time.push_back(courses.reference_time());
    difference.lost.push_back(time - courses.reference_time());
    steps.at(places.size());
  }
  difference.distance = distances(run, reference, times, difference.reference_time, watched);
  difference.pace = paces(difference.lost, places);
  return difference;
}

}  // namespace feedscope
