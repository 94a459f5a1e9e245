#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/analysis/agreement/path_matcher.h"
#include "core/analysis/agreement/programmed_course.h"
#include "core/analysis/agreement/recorded_errors.h"
#include "core/analysis/envelope/band.h"
#include "core/analysis/envelope/pyramid.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Velocity and acceleration of recorded positions, from parabolas fitted to short stretches (least squares;
/// Savitzky, Golay 1964) at their own, possibly uneven times.
///
/// A stretch has as many samples as keep the effect of position noise below 0.5 % of the mean feed and 0.03
/// m/s2, but lasts no longer than 20 ms or three samples (feed), five (acceleration): faster changes are
/// smoothed, as in every differentiated record. Stretches do not extend across gaps. Following errors are
/// those of the samples.
class TraceMotion {
 public:
  TraceMotion() = default;
  /// `record` outlives this. `noise`: of its positions [mm]; `period`: between its samples [s]; `errors`: of
  /// the same samples. Throws Cancelled.
  TraceMotion(const MotionRecord& record, const SeenAxes& seen, double noise, double period,
              const RecordedErrors& errors = {}, Progress* progress = nullptr);

  bool empty() const { return record_ == nullptr || record_->time.size() < 3; }
  /// At the sample nearest to `time` [s]: time, position, velocity, acceleration, speed and tangential
  /// acceleration; all else, and axes that are not recorded, NaN or 0.
  State state(double time) const;
  /// Following errors at the sample nearest to `time` [s]; none if none are recorded.
  std::optional<ActualSample> drives(double time) const;
  /// Whether the record has a quantity: feeds and accelerations of recorded axes, following errors of axes
  /// with actual positions.
  bool knows(QuantityId id) const;
  /// One band for each pair of neighbours in `times` [s], some of which may be NaN. Empty if one of a pair is
  /// NaN or nothing was recorded; between two samples, the band of the nearest one.
  std::vector<Band> columns(std::span<const double> times) const;

  double feed_window() const { return span_of(feed_half_); }                  ///< fitted over this time [s]
  double acceleration_window() const { return span_of(acceleration_half_); }  ///< [s]

 private:
  double span_of(std::size_t half) const { return 2 * static_cast<double>(half) * period_; }
  State sample(std::size_t i) const;
  ActualSample drives_of(std::size_t i) const;
  Band known(const MotionBand& band, const DriveBand& drives) const;
  void add_drives(DriveBand& band, std::size_t i) const;
  template <typename Groups, typename AnyBand, typename Add>
  static void add_samples(const Groups& groups, std::size_t first, std::size_t end, AnyBand& band, Add add);
  std::size_t nearest(double time) const;

  const MotionRecord* record_ = nullptr;
  SeenAxes seen_{};
  double period_ = 0;
  std::size_t feed_half_ = 1;  ///< samples on each side
  std::size_t acceleration_half_ = 2;
  Pyramid<MotionBand> groups_;
  RecordedErrors errors_;
  Pyramid<DriveBand> drive_groups_;  ///< empty without recorded errors
};

}  // namespace feedscope
