#pragma once

#include <memory>
#include <vector>

#include "ui/scene/camera/projection.h"
#include "ui/scene/path/colouring.h"
#include "ui/scene/path/path_part.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// A path as drawn: its points moved by enlarged deviations, its colours, and its visible parts.
///
/// Levels of detail with many points are drawn only in and around the view: close up nearly all of a long
/// path is outside of it, and every point of a line takes about 20 bytes in GPU buffers.
class DrawnPath {
 public:
  explicit DrawnPath(std::shared_ptr<const SampledPath> samples);

  const SampledPath& samples() const { return *samples_; }
  const std::shared_ptr<const SampledPath>& shared_samples() const { return samples_; }
  /// Draws deviations from the programmed path enlarged by `factor`; 1: true.
  void exaggerate(double factor);
  void set_colours(std::vector<Rgba> colours);
  /// Drawn positions, offsets from the path's origin [mm].
  const std::vector<Eigen::Vector3f>& positions() const {
    return moved_.empty() ? samples_->positions : moved_;
  }

  /// Boxes around the drawn spans.
  const std::vector<SpanBox>& boxes() const { return own_boxes_.empty() ? samples_->boxes : own_boxes_; }

  /// Makes a part of `level` that contains the visible range of `view`. Returns true if it differs from the
  /// previous one: drawings of this level, and of levels that no longer have a part, are then outdated.
  bool show(std::size_t level, const SceneFrame& frame, const Projection& view);
  /// Null if there is none.
  const PathPart* part(std::size_t level) const { return parts_[level].get(); }

 private:
  std::vector<bool> boxes_in(const SceneFrame& frame, const Projection& view, double margin) const;

  std::shared_ptr<const SampledPath> samples_;
  std::vector<Eigen::Vector3f> moved_;  ///< empty: not moved
  std::vector<SpanBox> own_boxes_;      ///< empty: those of the samples
  std::vector<Rgba> colours_;
  std::vector<std::unique_ptr<PathPart>> parts_;  ///< by level
};

}  // namespace feedscope::ui
