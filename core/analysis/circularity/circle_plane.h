#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>

namespace feedscope {

enum class CirclePlane : std::uint8_t { xy, zx, yz };

/// Names of a plane and its axes: angles count from the first towards the second.
struct PlaneInfo {
  CirclePlane plane = CirclePlane::xy;
  std::string_view name;  ///< "XY"
  std::string_view code;  ///< "G17"
  char first = 'X';       ///< axes
  char second = 'Y';
  char first_center = 'I';  ///< words of the centre
  char second_center = 'J';
  Eigen::Index first_index = 0;  ///< coordinates
  Eigen::Index second_index = 1;
};

const PlaneInfo& info_of(CirclePlane plane);
/// Parses "XY", "ZX" or "YZ". Throws InputError with these names.
CirclePlane parse_plane(const std::string& text);

}  // namespace feedscope
