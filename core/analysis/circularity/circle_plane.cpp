#include "core/analysis/circularity/circle_plane.h"

#include <fmt/format.h>

#include <array>

#include "core/base/error.h"

namespace feedscope {
namespace {

constexpr std::array<PlaneInfo, 3> planes{{
    {CirclePlane::xy, "XY", "G17", 'X', 'Y', 'I', 'J', 0, 1},
    {CirclePlane::zx, "ZX", "G18", 'Z', 'X', 'K', 'I', 2, 0},
    {CirclePlane::yz, "YZ", "G19", 'Y', 'Z', 'J', 'K', 1, 2},
}};

}  // namespace

const PlaneInfo& info_of(CirclePlane plane) {
  return planes[static_cast<std::size_t>(plane)];
}

CirclePlane parse_plane(const std::string& text) {
  for (const PlaneInfo& plane : planes) {
    if (text == plane.name) {
      return plane.plane;
    }
  }
  throw InputError(fmt::format("plane '{}' is unknown; it must be one of: XY, ZX, YZ", text));
}

}  // namespace feedscope
