#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <vector>

#include "ui/scene/path/colouring.h"
#include "ui/scene/sampled_path.h"

class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace feedscope::ui {

/// The points of one level of detail whose spans pass through some of the path's boxes, as VTK draws them,
/// with positions and colours shared by all lines of the part. Points outside take no GPU memory.
class PathPart {
 public:
  /// `positions` as drawn, offsets from the origin of `path`; `wanted`: by box, empty: all of them. `path`
  /// must outlive this. Linear in the level.
  PathPart(const SampledPath& path, const PathLevel& level, const std::vector<Eigen::Vector3f>& positions,
           std::vector<bool> wanted);
  ~PathPart();

  /// Whether all spans in `boxes` are in this part, without many more.
  bool fits(const std::vector<bool>& boxes) const;

  std::size_t size() const { return points_of_path_.size(); }
  /// Indices in the path, ascending.
  const std::vector<std::uint32_t>& points_of_path() const { return points_of_path_; }
  /// Index in the path of point `k`.
  std::size_t operator[](std::size_t k) const { return points_of_path_[k]; }
  /// Kind of the span from point `k` to the next one.
  SpanKind kind(std::size_t k) const { return path_.kinds[points_of_path_[k]]; }
  /// Whether there is a span from point `k` to the next one; the last point has none.
  bool joined(std::size_t k) const { return joined_[k]; }
  const SampledPath& path() const { return path_; }
  /// Drawn position of point `k`, offset from the path's origin [mm].
  Eigen::Vector3d position(std::size_t k) const;
  bool coloured() const;
  Rgba colour(std::size_t k) const;

  /// Sets the colours of all points of the path.
  void set_colours(const std::vector<Rgba>& colours);
  /// Lines or points between the points of this part, in its colours.
  vtkSmartPointer<vtkPolyData> poly_data(vtkCellArray& cells, bool points) const;

 private:
  const SampledPath& path_;
  std::vector<bool> wanted_;
  std::vector<std::uint32_t> points_of_path_;
  std::vector<bool> joined_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colours_;
};

}  // namespace feedscope::ui
