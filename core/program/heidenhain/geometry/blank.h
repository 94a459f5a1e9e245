#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/program/heidenhain/context.h"

namespace feedscope::heidenhain {

/// Corners of the blank (BLK FORM, G30, G31). They are only checked: the path does not depend on them.
class Blank : private Part {
 public:
  explicit Blank(Context& context) : Part(context) {}

  void set_corner(bool upper, const std::array<OptionalWord, 3>& corner, std::uint32_t column);

 private:
  std::optional<Vec3> lower_;
};

}  // namespace feedscope::heidenhain
