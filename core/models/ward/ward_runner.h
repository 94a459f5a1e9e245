#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/models/ward/pulse_train.h"
#include "core/models/ward/ward_settings.h"
#include "core/trajectory/stretch.h"

namespace feedscope {

/// Runs stretches from standstill to standstill, one after the other, into a trajectory: chooses the pulses
/// (ward_runner.cpp) and lays the filtered motion out as elements, pieces and records (ward_motion.cpp).
class WardRunner {
 public:
  WardRunner(const Toolpath& toolpath, const AxisVectors& axes, const WardSettings& settings,
             TrajectoryBuilder& builder);

  /// Lines and arcs without a stop between them. `steps` counts segments.
  void run(const StretchRange& range, ProgressSteps& steps);

 private:
  /// The corner nearest to the path, seen from the corner.
  struct Approach {
    double distance = 0;  ///< [mm]
    double time = 0;      ///< of the motion [s]
  };
  struct Span {
    double end = 0;  ///< of the motion [s]
    double q = 0;    ///< path length from the element's start [mm]
    Cause cause;
    bool settled = false;
  };

  void lay_links(const StretchRange& range);
  void add_arc_links(std::size_t segment, const MotionLimits& limits);
  void choose_filter_time();
  void choose_corner_speeds();
  FilteredMotion smooth(std::vector<Pulse> pulses) const;
  /// Lowers corner speeds until every corner keeps the tolerance.
  void enforce_tolerance(ProgressSteps& steps);
  /// Lowers those that are too far from the path and in `check`, which is cleared. True if any was.
  bool lower_corners(const FilteredMotion& motion, int pass);
  void mark_neighbours(const std::vector<double>& speeds_before);
  Approach approach(const FilteredMotion& motion, std::size_t corner, double good_enough) const;

  void lay_motion(const StretchRange& range, const FilteredMotion& motion, ProgressSteps& steps);
  void add_link_spans(const FilteredMotion& motion, std::size_t link);
  void add_span(const FilteredMotion& motion, double end, const Cause& cause, bool settled);
  /// Why the tool is not faster between `from` and `to`, where link `link` commands `feed`. `corner`: whose
  /// blending pulse that is, if one.
  Cause cause_between(const FilteredMotion& motion, double from, double to, std::size_t link, double feed,
                      std::optional<std::size_t> corner) const;
  bool slowed_by_tolerance(std::size_t corner) const;
  void add_record(const FilteredMotion& motion, std::size_t corner, std::uint32_t element);

  const Toolpath& toolpath_;
  AxisVectors axes_;
  WardSettings settings_;
  TrajectoryBuilder& builder_;

  double filter_time_ = 0;  ///< T1 [s]
  double half_delay_ = 0;   ///< c = n T1/2 [s]
  Vec3 end_;                ///< of the stretch [mm]
  std::vector<Link> links_;
  std::vector<double> corner_speeds_;  ///< at the start of each link, and at the end [mm/s]
  std::vector<double> link_start_;     ///< of the pulses, and their end [s]
  std::vector<char> check_;            ///< corners whose distance may have changed
  std::vector<Span> spans_;            ///< of the element under way
};

}  // namespace feedscope
