#include "ui/scene/path/drawn_path.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

namespace feedscope::ui {
namespace {

static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float), "VTK reads the positions as packed triples");
constexpr int do_not_free = 1;

}  // namespace

DrawnPath::DrawnPath(std::shared_ptr<const SampledPath> samples) : samples_(std::move(samples)) {
  colour_values_->SetNumberOfComponents(4);
  show_positions();
}

DrawnPath::~DrawnPath() = default;

void DrawnPath::show_positions() {
  const vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(3);
  if (!positions().empty()) {
    array->SetArray(const_cast<float*>(positions().front().data()),
                    static_cast<vtkIdType>(3 * positions().size()), do_not_free);
  }
  points_->SetData(array);
  points_->Modified();
}

void DrawnPath::exaggerate(double factor) {
  if (factor == 1 || samples_->deviations.empty()) {
    moved_ = {};
  } else {
    moved_ = samples_->positions;
    const auto more = static_cast<float>(factor - 1);
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      const StoredVector& deviation = samples_->deviations[i];
      moved_[i] += more * Eigen::Vector3f(float(deviation[0]), float(deviation[1]), float(deviation[2]));
    }
  }
  moved_boxes_ = boxes_of(moved_);
  show_positions();
}

void DrawnPath::set_colours(std::vector<Rgba> colours) {
  colours_ = std::move(colours);
  colour_values_->SetArray(colours_.empty() ? nullptr : colours_.front().data(),
                           static_cast<vtkIdType>(4 * colours_.size()), do_not_free);
  colour_values_->Modified();
}

vtkSmartPointer<vtkPolyData> DrawnPath::poly_data(vtkCellArray& cells, bool points) const {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points_);
  if (!colours_.empty()) {
    data->GetPointData()->SetScalars(colour_values_);
  }
  if (points) {
    data->SetVerts(&cells);
  } else {
    data->SetLines(&cells);
  }
  return data;
}

}  // namespace feedscope::ui
