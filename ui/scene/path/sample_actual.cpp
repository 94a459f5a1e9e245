#include "core/drives/span_looks.h"
#include "core/trajectory/state_walk.h"
#include "ui/scene/path/followed_foot.h"
#include "ui/scene/path/sampler.h"

namespace feedscope::ui {
namespace {

constexpr std::size_t spans_a_report = 4096;

/// Appends instants of the actual path.
class ActualSampling {
 public:
  ActualSampling(SampledPath& path, const ActualPath& actual, double spacing)
      : path_(path),
        trajectory_(actual.trajectory()),
        sampler_(path, spacing),
        end_sampler_(path, 0),
        foot_(*trajectory_.path().programmed()),
        set_(trajectory_),
        rigid_(actual.response().is_rigid()),
        walk_(actual.response()) {}

  bool done() const { return walk_.done(); }
  double time() const { return walk_.span().time; }
  /// Shifts of all points so far.
  std::vector<StoredVector> take_shifts() { return std::move(shifts_); }
  /// Samples one span. Adds its end only if nothing or a gap follows.
  void add_span() {
    const SetSpan& span = walk_.span();
    const SpanLooks looks(span, rigid_);
    for (int i = 0; i < looks.count(); ++i) {
      const double time = looks.at(i);
      const State state = set_.at_without_length(time);
      element_ = state.element;
      if (i == 0 && span.begins) {
        foot_.begin(trajectory_.path().segment(element_));
      }
      add(sampler_, walk_.within_span(time), time, state.speed * looks.duration(i));
    }
    const double end_time = span.end();
    const ActualMotion end = walk_.within_span(end_time);
    walk_.next_span();
    if (walk_.done() || walk_.span().begins) {
      add(end_sampler_, end, end_time, 0);
      path_.kinds.back() = SpanKind::gap;
    }
  }

 private:
  void add(Sampler& to, const ActualMotion& motion, double time, double length) {
    const PathDeviation::Result deviation =
        foot_.at(motion.position, trajectory_.path().segment(element_), motion.following_error.norm());
    if (!to.add(motion.position, trajectory_.is_rapid(element_) ? SpanKind::rapid : SpanKind::cut, length)) {
      return;
    }
    path_.times.push_back(time);
    const Eigen::Vector3f shift = deviation.along_bisector.cast<float>();
    shifts_.push_back({Stored(shift.x()), Stored(shift.y()), Stored(shift.z())});
  }

  SampledPath& path_;
  std::vector<StoredVector> shifts_;  ///< SampledDeviations::shifts
  const Trajectory& trajectory_;
  Sampler sampler_;
  Sampler end_sampler_;
  FollowedFoot foot_;
  std::uint32_t element_ = 0;  ///< the last element
  StateWalk set_;
  bool rigid_;
  ActualWalk walk_;
};

}  // namespace

SampledPath sample_actual(const ActualPath& actual, std::size_t max_points, Progress* progress) {
  const Trajectory& trajectory = actual.trajectory();
  SampledPath path;
  if (trajectory.pieces().empty()) {
    return path;
  }
  const bool rigid = actual.response().is_rigid();
  std::size_t wanted = 1;
  for (SetWalk walk(trajectory); !walk.done(); walk.next()) {
    wanted += static_cast<std::size_t>(SpanLooks(walk.span(), rigid).count());
  }
  path.origin = local_origin(*trajectory.path().programmed());
  const double spacing = spacing_for(wanted, max_points, trajectory.path_length());
  ActualSampling sampling(path, actual, spacing);
  for (std::size_t spans = 0; !sampling.done(); ++spans) {
    if (progress != nullptr && spans % spans_a_report == 0) {
      progress->report(sampling.time() / trajectory.duration());
    }
    sampling.add_span();
  }
  path.deviations = known_shifts(sampling.take_shifts());
  path.levels = levels_of(path);
  path.boxes = boxes_of(path.positions);
  return path;
}

}  // namespace feedscope::ui
