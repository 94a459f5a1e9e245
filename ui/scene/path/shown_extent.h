#pragma once

#include <initializer_list>
#include <memory>
#include <vector>

#include "core/base/geometry.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// Extent of paths for fitting a picture.
struct ShownExtent {
  Bounds all;     ///< of everything [mm]
  Bounds fitted;  ///< cut path, and the parts of the rest that are close to it [mm]

  /// Largest extent of the rest outside of `fitted`; 0 without paths [mm].
  double beyond() const;
};

/// Box around all except rapids [mm]; empty if nothing is cut.
Bounds cut_bounds(const SampledPath& path);

/// Extent of the given paths; null and empty ones are skipped. Rapids high above a part would leave it little
/// of the picture, so that `fitted` ends a fifth of its size away from the cut path.
ShownExtent shown_extent(std::initializer_list<std::shared_ptr<const SampledPath>> paths);

/// The points of cut paths, and with `rapids` those of rapids moved into `near` [mm], from the coarsest level
/// of detail; all points if nothing is cut.
std::vector<Vec3> outline_points(std::initializer_list<std::shared_ptr<const SampledPath>> paths,
                                 const Bounds& near, bool rapids);

}  // namespace feedscope::ui
