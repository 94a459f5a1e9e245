#pragma once

#include <Eigen/Core>
#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "core/analysis/contour/path_deviation.h"
#include "core/analysis/run/run_sources.h"
#include "core/base/progress.h"
#include "core/toolpath/toolpath.h"
#include "core/trajectory/trajectory.h"
#include "ui/scene/colourings.h"

namespace feedscope {
class ProgrammedCourse;
struct TraceOnProgram;
}  // namespace feedscope

namespace feedscope::ui {

/// Kind of a path between one point and the next.
enum class SpanKind : std::uint8_t {
  cut,
  rapid,
  blend,
  curve,  ///< on a smooth curve through several blocks
  gap,    ///< not drawn: the tool's way to the next place is unknown
};

/// 8 bits of mantissa, enough for colours.
using Stored = Eigen::bfloat16;
using StoredVector = std::array<Stored, 3>;

/// Points of a path without those closer than `spacing` [mm] to each other.
struct PathLevel {
  double spacing = 0;  ///< 0: all points
  std::size_t count = 0;
  std::vector<std::uint32_t> points;  ///< indices, ascending; empty if spacing is 0

  std::size_t size() const { return count; }
  std::size_t operator[](std::size_t i) const { return points.empty() ? i : points[i]; }
};

/// Box around consecutive spans, offsets from the path's origin [mm].
struct SpanBox {
  Eigen::Vector3f low, high;
};
inline constexpr std::size_t spans_of_box = 64;

/// Direction of the tool along the path, for machines with rotary axes that turn.
struct ToolAxis {
  Eigen::Vector3f tip;        ///< offset from the path's origin [mm]
  Eigen::Vector3f direction;  ///< from the tip to the spindle, unit
};
/// Largest number stored with a path.
inline constexpr std::size_t most_tool_axes = 4000;

/// Deviations of a path's points from the programmed one.
struct SampledDeviations {
  std::vector<Stored> errors;  ///< PathDeviation::Result::nearest [mm]; empty if no colour shows them
  std::vector<StoredVector>
      shifts;  ///< PathDeviation::Result::along_bisector [mm]; empty: cannot be enlarged
};

/// Deviations computed on first request, because few pictures show them. Several threads may request them.
class AskedDeviations {
 public:
  using Find = std::function<SampledDeviations(std::span<const double>)>;
  explicit AskedDeviations(Find find) : find_(std::move(find)) {}

  /// `times`: of all points, equal in every call [s].
  const SampledDeviations& at(std::span<const double> times) const;
  bool asked() const { return asked_.load(); }

 private:
  Find find_;
  mutable std::once_flag once_;
  mutable std::atomic<bool> asked_{false};
  mutable SampledDeviations found_;
};

/// A path as points close enough that straight spans between them look like the path. Positions are single
/// precision offsets from `origin`: one part in 10^7 of the path's size. An executed path takes 36 bytes per
/// point, 8 more for each of its deviations on request and a comparison with another run, and 4 more for its
/// levels and their search.
struct SampledPath {
  Vec3 origin = Vec3::Zero();              ///< [mm]
  std::vector<Eigen::Vector3f> positions;  ///< offsets from origin [mm]
  std::vector<SpanKind> kinds;             ///< of the span that starts at the point
  double peak_feed = 0;                    ///< largest feed on spans other than rapids [mm/s]
  Bounds bounds;                           ///< [mm]
  std::vector<ZeroPoint> zero_points;      ///< of a programmed path
  std::vector<PathLevel> levels;           ///< of detail, all points first
  std::vector<SpanBox> boxes;              ///< of an executed path

  // Empty for a programmed path. At a jump of a value, two points are in one place.
  std::vector<double> times;  ///< [s]
  /// By sample_index() of a colouring, in internal units; may be empty for comparisons with another run, and
  /// for sources that the run lacks.
  std::array<std::vector<Stored>, sampled_count> values;
  std::vector<CauseKind> causes;  ///< limiting cause
  /// Time of each kind of cause in the whole run, including rapids [s]; all 0 for a programmed path.
  std::array<double, cause_kind_count> cause_times{};
  std::array<double, cause_kind_count> reference_cause_times{};  ///< of the other run [s]; 0 without one
  std::shared_ptr<const AskedDeviations> deviations;             ///< see found_deviations(); null: none
  std::vector<float> lost;                     ///< RunDifference::lost [s]; empty without another run
  std::shared_ptr<const SampledPath> actual;   ///< actual path; null without drives
  std::shared_ptr<const RotaryCourse> rotary;  ///< of the run; null if no rotary axis turns
  std::vector<ToolAxis> tool_axes;             ///< along its feed motions; empty without `rotary`
  /// The run at the machine's X, Y and Z; null without `rotary` or if these are unknown.
  std::shared_ptr<const SampledPath> on_machine;

  std::size_t size() const { return positions.size(); }
  bool executed() const { return !times.empty(); }
  bool compared() const { return !lost.empty(); }
  Vec3 position(std::size_t i) const { return origin + positions[i].cast<double>(); }
  /// Computed by the first call, on all cores.
  const SampledDeviations& found_deviations() const;
  /// SampledDeviations::shifts
  Vec3 deviation(std::size_t i) const {
    const StoredVector& shift = found_deviations().shifts[i];
    return {double(float(shift[0])), double(float(shift[1])), double(float(shift[2]))};
  }
  const std::vector<Stored>& values_of(Colouring colouring) const {
    return colouring == Colouring::contour_error ? found_deviations().errors
                                                 : values[sample_index(colouring)];
  }
  double value(Colouring colouring, std::size_t i) const { return double(float(values_of(colouring)[i])); }
  /// Whether an executed path has values of this source.
  bool has(QuantitySource source) const {
    return source == QuantitySource::drives   ? actual != nullptr
           : source == QuantitySource::load   ? !values_of(Colouring::peak_force).empty()
           : source == QuantitySource::rotary ? rotary != nullptr
                                              : executed();
  }
};

/// A path that needs more points omits those closer than path length / max_points to each other; at most
/// three times as many remain.
inline constexpr std::size_t default_max_points = 2'000'000;

/// The programmed path: ends of lines, arcs every 3 degrees (coarser beyond the budget).
SampledPath sample_programmed(const Toolpath& toolpath, std::size_t max_points = default_max_points);

/// The executed path: arcs every 3 degrees, blends in spans of 2 degrees or with a deviation that a picture
/// can show, and a point wherever the feed has changed by about 1/24 of its peak. Linear in the pieces. Safe
/// to call outside the GUI thread. `also_at`: times of additional points where the spacing permits, ascending
/// [s]. `sources`: of its run. Throws Cancelled when stopped.
SampledPath sample_executed(const std::shared_ptr<const Trajectory>& trajectory,
                            std::size_t max_points = default_max_points, std::span<const double> also_at = {},
                            Progress* progress = nullptr, const RunSources& sources = {});

/// Contour error of a run at a time [mm]. `deviation`: from its programmed path.
double contour_error_at(const Trajectory& trajectory, const PathDeviation& deviation, double time);

/// A run in the coordinates of the machine, coloured as in those of the part: at the machine's X, Y and Z
/// while rotary axes turn part or tool; with points every 3 degrees of these too. Without deviations and tool
/// axes. `sources`: of the run, with a rotary course that knows_linear(). Throws Cancelled.
SampledPath sample_on_machine(const RunSources& sources, Progress* progress = nullptr);

/// The actual path: points at most 2 ms apart, or as far as the budget requires. Its deviations are from the
/// programmed path; it has no colours.
SampledPath sample_actual(const ActualPath& actual, std::size_t max_points = default_max_points,
                          Progress* progress = nullptr);

/// The recording of the first pass through the program, where it matches the path; gaps elsewhere.
/// Axes without a recording are at their programmed positions. Its deviations are from the programmed path;
/// it has no colours. `course`: of `toolpath`. Throws Cancelled.
SampledPath sample_recorded(const TraceOnProgram& trace, const ProgrammedCourse& course,
                            const Toolpath& toolpath, std::size_t max_points = default_max_points,
                            Progress* progress = nullptr);

/// The executed path of a run with its differences from a reference run of the same program. Also has points
/// where the reference changes its feed, unless both have enough points. `reference_times`: those of
/// sample_executed(reference) [s]. `sources`: of the run itself. Linear;
/// safe to call outside the GUI thread. Throws as compare_places().
SampledPath sample_compared(const std::shared_ptr<const Trajectory>& trajectory, const Trajectory& reference,
                            std::span<const double> reference_times, Progress* progress = nullptr,
                            const RunSources& sources = {});

/// Levels of detail of `path`: all points, then for a path of many points those needed in views where some
/// spacing is less than a pixel. Each level is at most half of the previous one, and the last is small enough
/// to be drawn while the view turns.
std::vector<PathLevel> levels_of(const SampledPath& path);

/// Boxes around the spans [64 i, 64 (i + 1)], for points at `positions`.
std::vector<SpanBox> boxes_of(const std::vector<Eigen::Vector3f>& positions);

/// Length of the spans of one kind [mm].
double length_of(const SampledPath& path, SpanKind kind);

}  // namespace feedscope::ui
