#pragma once

#include <initializer_list>
#include <memory>
#include <vector>

#include "core/base/geometry.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// What a picture of some paths is fitted to.
struct ShownExtent {
  Bounds all;     ///< of everything [mm]
  Bounds fitted;  ///< what is cut, and as much of the rest as is close to it [mm]

  /// How far the rest reaches beyond `fitted`; 0 where nothing is shown [mm].
  double beyond() const;
};

/// Around what is not rapid [mm]; empty: nothing is cut.
Bounds cut_bounds(const SampledPath& path);

/// Of the paths that are there; null ones and empty ones are skipped. Rapids high above a part would leave
/// little of the picture to it, so that `fitted` ends a fifth of its size away from what is cut.
ShownExtent shown_extent(std::initializer_list<std::shared_ptr<const SampledPath>> paths);

/// The points of what the paths cut, and with `rapids` those of rapids moved into `near` [mm], as coarse as
/// the paths are drawn when they are coarsest; all points where nothing is cut.
std::vector<Vec3> outline_points(std::initializer_list<std::shared_ptr<const SampledPath>> paths,
                                 const Bounds& near, bool rapids);

}  // namespace feedscope::ui
