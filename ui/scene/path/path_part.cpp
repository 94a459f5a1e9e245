#include "ui/scene/path/path_part.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <utility>

namespace feedscope::ui {

PathPart::PathPart(const SampledPath& path, const PathLevel& level,
                   const std::vector<Eigen::Vector3f>& positions, std::vector<bool> wanted)
    : path_(path), wanted_(std::move(wanted)) {
  std::vector<std::uint32_t> wanted_before(wanted_.size() + 1, 0);
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    wanted_before[i + 1] = wanted_before[i] + (wanted_[i] ? 1 : 0);
  }
  const auto is_wanted = [&](std::size_t from, std::size_t to) {
    return wanted_.empty() || wanted_before[(to - 1) / spans_of_box + 1] > wanted_before[from / spans_of_box];
  };
  for (std::size_t k = 0; k + 1 < level.size(); ++k) {
    const std::size_t from = level[k];
    const std::size_t to = level[k + 1];
    if (!is_wanted(from, to)) {
      continue;
    }
    if (points_of_path_.empty() || points_of_path_.back() != from) {
      points_of_path_.push_back(static_cast<std::uint32_t>(from));
      joined_.push_back(false);
    }
    joined_.back() = true;
    points_of_path_.push_back(static_cast<std::uint32_t>(to));
    joined_.push_back(false);
  }
  const vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(size()));
  for (std::size_t k = 0; k < size(); ++k) {
    array->SetTypedTuple(static_cast<vtkIdType>(k), positions[points_of_path_[k]].data());
  }
  points_->SetData(array);
  colours_->SetNumberOfComponents(4);
}

PathPart::~PathPart() = default;

bool PathPart::fits(const std::vector<bool>& boxes) const {
  constexpr std::size_t much = 16;         // times the requested number
  constexpr std::size_t few_boxes = 2000;  // drawn quickly
  std::size_t asked = 0;
  std::size_t here = 0;
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    if (boxes[i] && !wanted_[i]) {
      return false;
    }
    asked += boxes[i] ? 1 : 0;
    here += wanted_[i] ? 1 : 0;
  }
  return here <= few_boxes || here <= much * asked;
}

Eigen::Vector3d PathPart::position(std::size_t k) const {
  Eigen::Vector3d position;
  points_->GetPoint(static_cast<vtkIdType>(k), position.data());
  return position;
}

bool PathPart::coloured() const {
  return colours_->GetNumberOfTuples() > 0;
}

Rgba PathPart::colour(std::size_t k) const {
  Rgba colour{};
  colours_->GetTypedTuple(static_cast<vtkIdType>(k), colour.data());
  return colour;
}

void PathPart::set_colours(const std::vector<Rgba>& colours) {
  colours_->SetNumberOfTuples(static_cast<vtkIdType>(colours.empty() ? 0 : size()));
  for (std::size_t k = 0; k < size() && !colours.empty(); ++k) {
    colours_->SetTypedTuple(static_cast<vtkIdType>(k), colours[points_of_path_[k]].data());
  }
  colours_->Modified();
}

vtkSmartPointer<vtkPolyData> PathPart::poly_data(vtkCellArray& cells, bool points) const {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points_);
  if (coloured()) {
    data->GetPointData()->SetScalars(colours_);
  }
  if (points) {
    data->SetVerts(&cells);
  } else {
    data->SetLines(&cells);
  }
  return data;
}

}  // namespace feedscope::ui
