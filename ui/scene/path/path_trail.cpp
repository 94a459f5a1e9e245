#include "ui/scene/path/path_trail.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/scene/path/path_actors.h"
#include "ui/scene/path/view_detail.h"

namespace feedscope::ui {
namespace {

constexpr double width = 5;    // [pixels at scale 1]
constexpr double height = 12;  // [pixels at scale 1]: above all of the path
constexpr std::size_t most_points = 20'000;
constexpr double faintest = 0.08;  // opacity at the start

/// Lines with a colour for each point.
class FadingLines {
 public:
  FadingLines(const Rgb& colour, double from, double to) : from_(from), to_(to) {
    std::ranges::transform(colour, rgba_.begin(),
                           [](double share) { return static_cast<unsigned char>(std::lround(255 * share)); });
    colours_->SetNumberOfComponents(4);
  }

  /// `joined`: to the previous point.
  void add(const Eigen::Vector3d& place, double time, bool joined) {
    const vtkIdType id = points_->InsertNextPoint(place.data());
    const double share = std::clamp((time - from_) / (to_ - from_), 0.0, 1.0);
    rgba_[3] = static_cast<unsigned char>(std::lround(255 * std::lerp(faintest, 1.0, share)));
    colours_->InsertNextTypedTuple(rgba_.data());
    if (joined && id > 0) {
      const std::array<vtkIdType, 2> ends{id - 1, id};
      cells_->InsertNextCell(2, ends.data());
    }
  }

  vtkSmartPointer<vtkPolyData> data() const {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetLines(cells_);
    data->GetPointData()->SetScalars(colours_);
    return data;
  }

 private:
  double from_;
  double to_;
  std::array<unsigned char, 4> rgba_{};
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> colours_;
};

}  // namespace

PathTrail::PathTrail(vtkRenderer& renderer) : actor_(line_actor(*vtkNew<vtkPolyData>(), true)) {
  actor_->SetVisibility(0);
  renderer.AddActor(actor_);
}

PathTrail::~PathTrail() = default;

void PathTrail::end_at(const std::optional<double>& time, const std::optional<Vec3>& tip) {
  time_ = time;
  tip_ = tip.value_or(Vec3::Zero());
}

void PathTrail::place(const DrawnPath* path, const Rgb& colour, const SceneFrame& frame,
                      const Projection& view, double scale) {
  const bool shown = path != nullptr && path->samples().executed() && time_ && length_ > 0 && *time_ > 0;
  actor_->SetVisibility(shown ? 1 : 0);
  if (!shown) {
    return;
  }
  const SampledPath& samples = path->samples();
  const double first = std::max(0.0, *time_ - length_);
  FadingLines lines(colour, first, *time_);
  const PathLevel& level = samples.levels[level_of(samples, frame, view, false)];
  const auto time_at = [&](std::size_t k) { return samples.times[level[k]]; };
  const auto place_at = [&](std::size_t k) -> Eigen::Vector3d {
    return path->positions()[level[k]].cast<double>();
  };
  const auto count_of = [&](const auto& passed) {  // number of points at past times
    const auto point_passed = [&](std::uint32_t point) { return passed(samples.times[point]); };
    return static_cast<std::size_t>(
        level.points.empty()
            ? std::ranges::partition_point(samples.times, passed) - samples.times.begin()
            : std::ranges::partition_point(level.points, point_passed) - level.points.begin());
  };
  const std::size_t begin = count_of([&](double time) { return time <= first; });
  const std::size_t end = count_of([&](double time) { return time < *time_; });
  const auto joined = [&](std::size_t k) { return k > 0 && samples.kinds[level[k - 1]] != SpanKind::gap; };
  if (begin > 0 && begin < level.size() && joined(begin)) {
    const double share = (first - time_at(begin - 1)) / (time_at(begin) - time_at(begin - 1));
    lines.add(place_at(begin - 1) + share * (place_at(begin) - place_at(begin - 1)), first, false);
  }
  const std::size_t step = end > begin ? (end - begin) / most_points + 1 : 1;
  for (std::size_t k = begin; k < end; k += step) {
    lines.add(place_at(k), time_at(k), joined(k));
  }
  lines.add(tip_ - samples.origin, *time_, end == 0 || joined(end));
  static_cast<vtkPolyDataMapper*>(actor_->GetMapper())->SetInputData(lines.data());

  const auto pixels = static_cast<float>(std::max(1.0, width * scale));
  actor_->GetProperty()->SetLineWidth(pixels);
  const Projection::Lift lift = view.lift(height * std::max(scale / view.scale, 2e-6));
  const Vec3 at = lift.shift + lift.shrink * frame.to_scene(samples.origin);
  actor_->SetScale(lift.shrink / frame.unit);
  actor_->SetPosition(at.x(), at.y(), at.z());
}

}  // namespace feedscope::ui
