#include "core/analysis/agreement/trace_motion.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr std::size_t group = 32;           // samples per stored band
constexpr double feed_noise_share = 0.005;  // of the mean feed: largest contribution of noise
constexpr double least_feed_noise = 0.01;   // [mm/s]
constexpr double acceleration_noise = 30;   // [mm/s2]
constexpr double longest_half = 0.010;      // [s] on each side
constexpr double gap = 1.6;                 // periods; samples farther apart have a gap between them

/// Noise of the slope in the middle of 2 m + 1 evenly spaced samples, for noise 1 at steps of 1.
double slope_noise(double m) {
  return std::sqrt(3 / (m * (m + 1) * (2 * m + 1)));
}

/// Noise of the second derivative of a parabola, likewise.
double curvature_noise(double m) {
  return std::sqrt(180 / ((2 * m - 1) * m * (m + 1) * (2 * m + 1) * (2 * m + 3)));
}

/// Smallest number of samples on each side, from `least` to `most`, with a noise of at most `allowed`.
template <typename Noise>
std::size_t half_for(std::size_t least, std::size_t most, double allowed, Noise noise) {
  std::size_t m = least;
  while (m < most && noise(static_cast<double>(m)) > allowed) {
    ++m;
  }
  return m;
}

struct Derivatives {
  Vec3 first = Vec3::Zero();
  Vec3 second = Vec3::Zero();
};

/// Derivatives at sample `i` of the best-fitting parabola through the samples around it on its side of gaps;
/// of two samples the slope alone.
Derivatives fit(const MotionRecord& record, std::size_t i, std::size_t half, double period) {
  std::size_t first = i;
  while (first > 0 && i - first < half && record.time[first] - record.time[first - 1] < gap * period) {
    --first;
  }
  std::size_t last = i;
  while (last + 1 < record.time.size() && last - i < half &&
         record.time[last + 1] - record.time[last] < gap * period) {
    ++last;
  }
  double s1 = 0;
  double s2 = 0;
  double s3 = 0;
  double s4 = 0;
  Vec3 p0 = Vec3::Zero();
  Vec3 p1 = Vec3::Zero();
  Vec3 p2 = Vec3::Zero();
  for (std::size_t k = first; k <= last; ++k) {
    const double t = (record.time[k] - record.time[i]) / period;
    const Vec3 p = record.place[k] - record.place[i];
    s1 += t;
    s2 += t * t;
    s3 += t * t * t;
    s4 += t * t * t * t;
    p0 += p;
    p1 += t * p;
    p2 += t * t * p;
  }
  const auto n = static_cast<double>(last - first + 1);
  if (last - first < 2) {
    return {last > first ? Vec3((n * p1 - s1 * p0) / (n * s2 - s1 * s1) / period) : Vec3(Vec3::Zero()),
            Vec3::Zero()};
  }
  // Cramer's rule on the normal equations of a + b t + c t2.
  const double determinant = n * (s2 * s4 - s3 * s3) - s1 * (s1 * s4 - s3 * s2) + s2 * (s1 * s3 - s2 * s2);
  const Vec3 b =
      (n * (p1 * s4 - p2 * s3) - p0 * (s1 * s4 - s2 * s3) + s2 * (s1 * p2 - s2 * p1)) / determinant;
  const Vec3 c =
      (n * (s2 * p2 - s3 * p1) - s1 * (s1 * p2 - s2 * p1) + p0 * (s1 * s3 - s2 * s2)) / determinant;
  return {b / period, 2 * c / (period * period)};
}

double mean_feed(const MotionRecord& record, std::size_t stride) {
  double length = 0;
  for (std::size_t i = stride; i < record.place.size(); i += stride) {
    length += (record.place[i] - record.place[i - stride]).norm();
  }
  const double time = record.time.back() - record.time.front();
  return time > 0 ? length / time : 0;
}

}  // namespace

TraceMotion::TraceMotion(const MotionRecord& record, const SeenAxes& seen, double noise, double period,
                         const RecordedErrors& errors, Progress* progress)
    : record_(&record), seen_(seen), period_(period), errors_(errors) {
  if (empty() || !(period > 0)) {
    record_ = nullptr;
    return;
  }
  constexpr std::size_t coarse = 10;  // samples apart: over these distances noise adds no length
  const double allowed = std::max(least_feed_noise, feed_noise_share * mean_feed(record, coarse));
  const auto most = static_cast<std::size_t>(longest_half / period);
  feed_half_ = half_for(1, std::max<std::size_t>(1, most), allowed * period,
                        [noise](double m) { return noise * slope_noise(m); });
  acceleration_half_ = half_for(2, std::max<std::size_t>(2, most), acceleration_noise * period * period,
                                [noise](double m) { return noise * curvature_noise(m); });
  std::vector<MotionBand> groups;
  groups.reserve(record.time.size() / group + 1);
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    if (i % group == 0) {
      groups.emplace_back();
      if (progress != nullptr) {
        progress->report(static_cast<double>(i) / static_cast<double>(record.time.size()));
      }
    }
    groups.back().add(Instant(sample(i)));
  }
  groups_ = Pyramid<MotionBand>(std::move(groups));
  if (!errors_.empty()) {
    std::vector<DriveBand> drives(record.time.size() / group + 1);
    for (std::size_t i = 0; i < record.time.size(); ++i) {
      add_drives(drives[i / group], i);
    }
    drive_groups_ = Pyramid<DriveBand>(std::move(drives));
  }
}

ActualSample TraceMotion::drives_of(std::size_t i) const {
  ActualSample sample;
  sample.motion.position = record_->place[i];
  sample.motion.velocity = Vec3::Zero();
  sample.motion.following_error = errors_.at(i);
  return sample;
}

std::optional<ActualSample> TraceMotion::drives(double time) const {
  return errors_.empty() ? std::nullopt : std::optional(drives_of(nearest(time)));
}

State TraceMotion::sample(std::size_t i) const {
  State state = Trajectory().state(0);
  const Vec3 velocity = fit(*record_, i, feed_half_, period_).first;
  const Vec3 acceleration = fit(*record_, i, acceleration_half_, period_).second;
  for (int axis = 0; axis < 3; ++axis) {
    const bool seen = seen_[static_cast<std::size_t>(axis)];
    state.velocity[axis] = seen ? velocity[axis] : 0;
    state.acceleration[axis] = seen ? acceleration[axis] : 0;
  }
  state.time = record_->time[i];
  state.position = record_->place[i];
  state.speed = state.velocity.norm();
  state.tangential_acceleration =
      state.speed > 0 ? state.acceleration.dot(state.velocity) / state.speed : state.acceleration.norm();
  return state;
}

bool TraceMotion::knows(QuantityId id) const {
  switch (id) {
    case QuantityId::feed:
    case QuantityId::tangential_acceleration:
    case QuantityId::acceleration_across:
      return seen_[0] || seen_[1] || seen_[2];
    case QuantityId::velocity_x:
    case QuantityId::acceleration_x:
      return seen_[0];
    case QuantityId::velocity_y:
    case QuantityId::acceleration_y:
      return seen_[1];
    case QuantityId::velocity_z:
    case QuantityId::acceleration_z:
      return seen_[2];
    case QuantityId::following_error_x:
      return errors_.has(0);
    case QuantityId::following_error_y:
      return errors_.has(1);
    case QuantityId::following_error_z:
      return errors_.has(2);
    default:
      return false;
  }
}

Band TraceMotion::known(const MotionBand& band, const DriveBand& drives) const {
  Band shown;
  shown.add(band);
  shown.add(drives);
  for (const ChartedRange& range : {charted_of_motion, charted_of_drives}) {
    for (std::size_t i = 0; i < range.count; ++i) {
      const auto id = static_cast<QuantityId>(static_cast<std::size_t>(range.first) + i);
      if (!knows(id)) {
        shown[id] = Extent();
      }
    }
  }
  return shown;
}

/// Adds the samples [first, end): whole groups as stored, the others by `add`.
template <typename Groups, typename AnyBand, typename Add>
void TraceMotion::add_samples(const Groups& groups, std::size_t first, std::size_t end, AnyBand& band,
                              Add add) {
  const std::size_t first_group = (first + group - 1) / group;
  const std::size_t end_group = end / group;
  for (std::size_t k = first; k < std::min(end, first_group * group); ++k) {
    add(band, k);
  }
  if (first_group < end_group) {
    groups.add(band, first_group, end_group);
  }
  for (std::size_t k = std::max(first_group, end_group) * group; k < end; ++k) {
    add(band, k);
  }
}

void TraceMotion::add_drives(DriveBand& band, std::size_t i) const {
  static const State still = Trajectory().state(0);
  const ActualSample sample = drives_of(i);
  band.add(Instant(still, &sample));
}

std::size_t TraceMotion::nearest(double time) const {
  const auto found = std::ranges::lower_bound(record_->time, time);
  if (found == record_->time.end()) {
    return record_->time.size() - 1;
  }
  const auto i = static_cast<std::size_t>(found - record_->time.begin());
  return i > 0 && time - record_->time[i - 1] < *found - time ? i - 1 : i;
}

State TraceMotion::state(double time) const {
  return sample(nearest(time));
}

std::vector<Band> TraceMotion::columns(std::span<const double> times) const {
  std::vector<Band> bands(times.size() < 2 || empty() ? 0 : times.size() - 1);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    if (std::isnan(times[i]) || std::isnan(times[i + 1])) {
      continue;
    }
    const auto [earlier, later] = std::minmax(times[i], times[i + 1]);
    const double from = std::max(earlier, record_->time.front());
    const double to = std::min(later, record_->time.back());
    if (to < from) {
      continue;
    }
    const std::size_t first = nearest(from);
    const std::size_t last = nearest(to);
    MotionBand band;
    if (record_->time[last] > to + period_ || record_->time[first] < from - period_) {
      continue;  // in a gap
    }
    add_samples(groups_, first, last + 1, band,
                [this](MotionBand& sum, std::size_t k) { sum.add(Instant(sample(k))); });
    DriveBand drives;
    if (!errors_.empty()) {
      add_samples(drive_groups_, first, last + 1, drives,
                  [this](DriveBand& sum, std::size_t k) { add_drives(sum, k); });
    }
    bands[i] = known(band, drives);
  }
  return bands;
}

}  // namespace feedscope
