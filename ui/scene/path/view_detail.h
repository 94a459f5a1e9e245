#pragma once

#include "ui/scene/camera/projection.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// Share of the frame's outline on the screen that lines would cover; `drawn`: length times width [mm
/// pixels].
double crowding(const SceneFrame& frame, const Projection& view, double drawn);

/// The level of `path` with all details of a pixel or more; coarser while the view moves. The path has
/// levels.
std::size_t level_of(const SampledPath& path, const SceneFrame& frame, const Projection& view, bool moving);

}  // namespace feedscope::ui
