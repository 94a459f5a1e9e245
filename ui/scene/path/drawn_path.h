#pragma once

#include <memory>
#include <vector>

#include "ui/scene/camera/projection.h"
#include "ui/scene/path/colouring.h"
#include "ui/scene/path/path_part.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// A path as it is drawn: where deviations put its points, its colours, and the parts of it that views show.
///
/// Levels of detail with many points are drawn only in and around the view: close up nearly all of a long
/// path is outside of it, and every point of a line takes some 20 bytes in buffers of the GPU.
class DrawnPath {
 public:
  explicit DrawnPath(std::shared_ptr<const SampledPath> samples);

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
  const std::vector<SpanBox>& boxes() const { return own_boxes_.empty() ? samples_->boxes : own_boxes_; }

  /// Makes a part of `level` that holds what `view` shows. True if it is another one than before: what was
  /// drawn of this level, and of levels that have no part any more, is out of date.
  bool show(std::size_t level, const SceneFrame& frame, const Projection& view);
  /// Null: there is none.
  const PathPart* part(std::size_t level) const { return parts_[level].get(); }

 private:
  std::vector<bool> boxes_in(const SceneFrame& frame, const Projection& view, double margin) const;

  std::shared_ptr<const SampledPath> samples_;
  std::vector<Eigen::Vector3f> moved_;  ///< empty: where they are
  std::vector<SpanBox> own_boxes_;      ///< empty: those of the samples
  std::vector<Rgba> colours_;
  std::vector<std::unique_ptr<PathPart>> parts_;  ///< by level
};

}  // namespace feedscope::ui
