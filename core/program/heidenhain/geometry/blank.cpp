#include "core/program/heidenhain/geometry/blank.h"

namespace feedscope::heidenhain {

void Blank::set_corner(bool upper, const std::array<OptionalWord, 3>& words, std::uint32_t column) {
  Vec3 corner = upper && lower_ ? *lower_ : Vec3(0, 0, 0);
  for (int axis = 0; axis < 3; ++axis) {
    const OptionalWord& word = words[static_cast<std::size_t>(axis)];
    corner[axis] = word.incremental ? corner[axis] + word.value : word.value;
  }
  if (!upper) {
    lower_ = corner;
  } else if (lower_ && !(corner.array() > lower_->array()).all()) {
    report(Severity::warning, "blank-form", 0, column, [] {
      return Text{NC_("core", "the upper corner of the blank is not above the lower one in every axis"),
                  NC_("core", "the control refuses such a blank; the path does not depend on it")};
    });
  }
}

}  // namespace feedscope::heidenhain
