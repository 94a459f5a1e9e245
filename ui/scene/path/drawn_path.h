#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

#include "ui/scene/path/colouring.h"
#include "ui/scene/sampled_path.h"

class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace feedscope::ui {

/// A path as VTK draws it: positions and colours that all its lines share.
class DrawnPath {
 public:
  explicit DrawnPath(std::shared_ptr<const SampledPath> samples);
  ~DrawnPath();

  const SampledPath& samples() const { return *samples_; }
  const std::shared_ptr<const SampledPath>& shared_samples() const { return samples_; }
  /// Draws deviations from the programmed path `factor` times as large; 1: as they are.
  void exaggerate(double factor);
  void set_colours(std::vector<Rgba> colours);
  /// As drawn, offsets from the path's origin [mm].
  const std::vector<Eigen::Vector3f>& positions() const {
    return moved_.empty() ? samples_->positions : moved_;
  }

  /// Boxes around the spans as drawn.
  const std::vector<SpanBox>& boxes() const { return moved_.empty() ? samples_->boxes : moved_boxes_; }

  /// Lines or points of this path; they follow its positions and colours.
  vtkSmartPointer<vtkPolyData> poly_data(vtkCellArray& cells, bool points) const;

 private:
  void show_positions();

  std::shared_ptr<const SampledPath> samples_;
  std::vector<Eigen::Vector3f> moved_;  ///< empty: where they are
  std::vector<SpanBox> moved_boxes_;
  std::vector<Rgba> colours_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colour_values_;
};

}  // namespace feedscope::ui
