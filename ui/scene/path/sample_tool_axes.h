#pragma once

#include <vector>

#include "core/analysis/rotary/rotary_course.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// Tool axes along the feed motions of a run, evenly by path length, at most most_tool_axes; offsets from
/// `origin` [mm].
std::vector<ToolAxis> sample_tool_axes(const RotaryCourse& course, const Vec3& origin);

}  // namespace feedscope::ui
