#pragma once

#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Corner `i` of `path`, a blend or a connecting arc; without its speeds.
BlendRecord laid_corner(const BlendedPath& path, std::size_t i);

/// A corner that the control rounds in its own way, by an arc or where two blocks overlap; without its
/// speeds.
BlendRecord rounded_corner(const BlendedPath& path, const RoundedCorner& corner);

}  // namespace feedscope
