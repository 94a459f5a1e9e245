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

#include "core/analysis/path_deviation.h"
#include "core/analysis/run_sources.h"
#include "core/base/progress.h"
#include "core/toolpath/toolpath.h"
#include "core/trajectory/trajectory.h"
#include "ui/scene/colourings.h"

namespace feedscope {
class ProgrammedCourse;
struct TraceOnProgram;
}  // namespace feedscope

namespace feedscope::ui {

/// What the path does between one point and the next.
enum class SpanKind : std::uint8_t {
  cut,
  rapid,
  blend,
  curve,  ///< on a smooth curve through several blocks
  gap,    ///< it goes on elsewhere, and how the tool gets there is not known: nothing is drawn
};

/// 8 bits of mantissa: what colours can show.
using Stored = Eigen::bfloat16;
using StoredVector = std::array<Stored, 3>;

/// Points of a path that are left when those closer than `spacing` [mm] to each other are omitted.
struct PathLevel {
  double spacing = 0;  ///< 0: all points
  std::size_t count = 0;
  std::vector<std::uint32_t> points;  ///< indices, rising; empty where spacing is 0

  std::size_t size() const { return count; }
  std::size_t operator[](std::size_t i) const { return points.empty() ? i : points[i]; }
};

/// Box around consecutive spans, offsets from the path's origin [mm].
struct SpanBox {
  Eigen::Vector3f low, high;
};
inline constexpr std::size_t spans_of_box = 64;

/// Where the tool points on the way, for machines whose rotary axes turn.
struct ToolAxis {
  Eigen::Vector3f tip;        ///< offset from the path's origin [mm]
  Eigen::Vector3f direction;  ///< from the tip to the spindle, unit
};
/// Most of them that a path keeps.
inline constexpr std::size_t most_tool_axes = 4000;

/// How far the points of a path are from the programmed one.
struct SampledDeviations {
  std::vector<Stored> errors;  ///< PathDeviation::Result::nearest [mm]; empty where no colour shows them
  std::vector<StoredVector>
      shifts;  ///< PathDeviation::Result::along_bisector [mm]; empty: not to be enlarged
};

/// The same, found when first asked for: few pictures show them. May be asked by several threads.
class AskedDeviations {
 public:
  using Find = std::function<SampledDeviations(std::span<const double>)>;
  explicit AskedDeviations(Find find) : find_(std::move(find)) {}

  /// `times`: of all points, the same in every call [s].
  const SampledDeviations& at(std::span<const double> times) const;
  bool asked() const { return asked_.load(); }

 private:
  Find find_;
  mutable std::once_flag once_;
  mutable std::atomic<bool> asked_{false};
  mutable SampledDeviations found_;
};

/// A path as points close enough that straight spans between them look like the path. Positions are single
/// precision offsets from `origin`: one part in 10^7 of the path's size. An executed path takes 36 bytes a
/// point, 8 more each when its deviations are asked for and while it is compared with another run, its levels
/// and what finds them 4 more.
struct SampledPath {
  Vec3 origin = Vec3::Zero();              ///< [mm]
  std::vector<Eigen::Vector3f> positions;  ///< offsets from origin [mm]
  std::vector<SpanKind> kinds;             ///< of the span that begins at the point
  double peak_feed = 0;                    ///< largest feed on spans that are not rapid [mm/s]
  Bounds bounds;                           ///< [mm]
  std::vector<ZeroPoint> zero_points;      ///< of a programmed path
  std::vector<PathLevel> levels;           ///< of detail, all points first
  std::vector<SpanBox> boxes;              ///< of an executed path

  // Empty for a programmed path. Where a value jumps, two points lie in one place.
  std::vector<double> times;  ///< [s]
  /// By sample_index() of a colouring, in inside units; those against another run, and those of what a run
  /// has not, may be empty.
  std::array<std::vector<Stored>, sampled_count> values;
  std::vector<CauseKind> causes;  ///< limiting cause
  /// What each kind of cause takes of the whole run, rapids included [s]; all 0 for a programmed path.
  std::array<double, cause_kind_count> cause_times{};
  std::array<double, cause_kind_count> reference_cause_times{};  ///< of the other run; 0 without one [s]
  std::shared_ptr<const AskedDeviations> deviations;             ///< see found_deviations(); null: none
  std::vector<float> lost;                     ///< RunDifference::lost [s]; empty without another run
  std::shared_ptr<const SampledPath> actual;   ///< what the axes run; null without drives
  std::shared_ptr<const RotaryCourse> rotary;  ///< of the run; null where no rotary axis turns
  std::vector<ToolAxis> tool_axes;             ///< along its feed motions; empty without `rotary`
  /// The run where X, Y and Z of the machine stand; null without `rotary` or where they are not known.
  std::shared_ptr<const SampledPath> on_machine;

  std::size_t size() const { return positions.size(); }
  bool executed() const { return !times.empty(); }
  bool compared() const { return !lost.empty(); }
  Vec3 position(std::size_t i) const { return origin + positions[i].cast<double>(); }
  /// Found by the first call, on all cores.
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
  /// Whether an executed path has what comes from this source.
  bool has(QuantitySource source) const {
    return source == QuantitySource::drives   ? actual != nullptr
           : source == QuantitySource::load   ? !values_of(Colouring::peak_force).empty()
           : source == QuantitySource::rotary ? rotary != nullptr
                                              : executed();
  }
};

/// A path that needs more points than this leaves out those closer than path length / max_points to each
/// other; at most three times as many remain.
inline constexpr std::size_t default_max_points = 2'000'000;

/// The programmed path: ends of lines, arcs every 3 degrees (coarser where the budget ends).
SampledPath sample_programmed(const Toolpath& toolpath, std::size_t max_points = default_max_points);

/// The executed path: arcs every 3 degrees, blends in spans of 2 degrees or as far from them as a picture can
/// show, and wherever the feed changes by some 1/24 of its peak. Linear in the pieces. Safe to call off the
/// GUI thread. `also_at`: times at which there are points too where the spacing allows, rising [s].
/// `sources`: of its run. Throws Cancelled when stopped.
SampledPath sample_executed(const std::shared_ptr<const Trajectory>& trajectory,
                            std::size_t max_points = default_max_points, std::span<const double> also_at = {},
                            Progress* progress = nullptr, const RunSources& sources = {});

/// Contour error of a run at a time [mm]. `deviation`: from its programmed path, which it has.
double contour_error_at(const Trajectory& trajectory, const PathDeviation& deviation, double time);

/// A run in the coordinates of the machine, coloured as in those of the part: where X, Y and Z stand while
/// rotary axes turn part or tool; points every 3 degrees of these too. Without deviations and tool axes.
/// `sources`: of the run, with a rotary course that knows_linear(). Throws Cancelled.
SampledPath sample_on_machine(const RunSources& sources, Progress* progress = nullptr);

/// The path that the axes run: points 2 ms apart at most, or as far as the budget allows. Its deviations are
/// from the programmed path; it has no colours.
SampledPath sample_actual(const ActualPath& actual, std::size_t max_points = default_max_points,
                          Progress* progress = nullptr);

/// What a control recorded of the first pass through the program, where it fits; gaps where it does not.
/// Axes that are not recorded are where the program has them. Its deviations are from the programmed path; it
/// has no colours. `course`: of `toolpath`. Throws Cancelled.
SampledPath sample_recorded(const TraceOnProgram& trace, const ProgrammedCourse& course,
                            const Toolpath& toolpath, std::size_t max_points = default_max_points,
                            Progress* progress = nullptr);

/// The executed path of a run with what it does unlike a reference run of the same program. It has points
/// where the reference changes its feed, too, unless both have so many that they are close enough.
/// `reference_times`: those of sample_executed(reference) [s]. `sources`: of the run itself. Linear;
/// safe to call off the GUI thread. Throws what compare_places() throws.
SampledPath sample_compared(const std::shared_ptr<const Trajectory>& trajectory, const Trajectory& reference,
                            std::span<const double> reference_times, Progress* progress = nullptr,
                            const RunSources& sources = {});

/// Levels of detail of `path`: all points; then, if it has many, what is left in views in which some spacing
/// is less than a pixel, each level at most half of the one before; the last one small enough to be drawn
/// while the view turns.
std::vector<PathLevel> levels_of(const SampledPath& path);

/// Boxes around the spans [64 i, 64 (i + 1)], for points at `positions`.
std::vector<SpanBox> boxes_of(const std::vector<Eigen::Vector3f>& positions);

/// Length of the spans of one kind [mm].
double length_of(const SampledPath& path, SpanKind kind);

}  // namespace feedscope::ui
