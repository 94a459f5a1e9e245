#include "core/program/sinumerik/geometry/frame_value.h"

#include <utility>

#include "core/program/sinumerik/geometry/frames.h"
#include "core/program/text/scanner.h"

namespace feedscope::sinumerik {

std::optional<FrameValue::Part> FrameValue::part(std::string_view name) {
  constexpr auto names = std::to_array<std::pair<std::string_view, Part>>({{"TR", Part::shift},
                                                                           {"FI", Part::fine_shift},
                                                                           {"RT", Part::angle},
                                                                           {"SC", Part::scale},
                                                                           {"MI", Part::mirror}});
  for (const auto& [known, part] : names) {
    if (letters::same(known, name)) {
      return part;
    }
  }
  return std::nullopt;
}

bool FrameValue::set(Part part, int axis, double value) {
  if (chain_) {
    return false;
  }
  switch (part) {
    case Part::shift:
      shift_[axis] = value;
      break;
    case Part::fine_shift:
      fine_shift_[axis] = value;
      break;
    case Part::angle:
      angles_[axis] = value;
      break;
    case Part::scale:
      factors_[axis] = value;
      break;
    case Part::mirror:
      mirror_[axis] = value != 0 ? -1 : 1;
      break;
  }
  return true;
}

CoordinateFrame FrameValue::frame() const {
  return chain_ ? *chain_
                : CoordinateFrame::shift(shift_ + fine_shift_) * turned_about(angles_) *
                      CoordinateFrame::scale(factors_) * CoordinateFrame::scale(mirror_);
}

}  // namespace feedscope::sinumerik
