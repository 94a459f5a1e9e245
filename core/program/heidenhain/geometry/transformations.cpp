#include "core/program/heidenhain/geometry/transformations.h"

#include <algorithm>

namespace feedscope::heidenhain {

Transformations::Step& Transformations::step(Kind kind) {
  const auto found =
      std::find_if(steps_.begin(), steps_.end(), [kind](const Step& s) { return s.kind == kind; });
  if (found != steps_.end()) {
    return *found;
  }
  Step& added = steps_.emplace_back();
  added.kind = kind;
  return added;
}

const Transformations::Step* Transformations::find(Kind kind) const {
  const auto found =
      std::find_if(steps_.begin(), steps_.end(), [kind](const Step& s) { return s.kind == kind; });
  return found != steps_.end() ? &*found : nullptr;
}

Vec3 Transformations::shift() const {
  const Step* found = find(Kind::shift);
  return found != nullptr ? found->values : Vec3(Vec3::Zero());
}

CoordinateFrame Transformations::tilt() const {
  const Step* found = find(Kind::tilt);
  return found != nullptr ? found->tilt : CoordinateFrame();
}

bool Transformations::has_shift_under_tilt() const {
  const Step* shift = find(Kind::shift);
  const Step* tilt = find(Kind::tilt);
  return shift != nullptr && tilt != nullptr && shift < tilt;
}

void Transformations::reset(Kind kind) {
  std::erase_if(steps_, [kind](const Step& s) { return s.kind == kind; });
}

void Transformations::shift(int axis, double value, bool incremental) {
  Vec3& datum = step(Kind::shift).values;
  datum[axis] = incremental ? datum[axis] + value : value;
  if (datum == Vec3::Zero()) {
    reset(Kind::shift);
  }
}

void Transformations::mirror(const std::array<bool, 3>& axes) {
  reset(Kind::mirror);
  if (axes[0] || axes[1] || axes[2]) {
    step(Kind::mirror).values = Vec3(axes[0] ? -1 : 1, axes[1] ? -1 : 1, axes[2] ? -1 : 1);
  }
}

void Transformations::rotate(Plane plane, double angle, bool incremental) {
  Step& rotation = step(Kind::rotation);
  rotation.angle = incremental ? rotation.angle + angle : angle;
  rotation.plane = plane;
  if (rotation.angle == 0) {
    reset(Kind::rotation);
  }
}

void Transformations::scale(const Vec3& factors, const Vec3& center) {
  if (factors == Vec3::Ones()) {
    reset(Kind::scale);
    return;
  }
  Step& scaling = step(Kind::scale);
  scaling.values = factors;
  scaling.center = center;
}

CoordinateFrame Transformations::frame() const {
  CoordinateFrame frame;
  for (const Step& step : steps_) {
    switch (step.kind) {
      case Kind::shift:
        frame = frame * CoordinateFrame::shift(step.values);
        break;
      case Kind::mirror:
        frame = frame * CoordinateFrame::scale(step.values);
        break;
      case Kind::rotation:
        frame = frame * CoordinateFrame::rotation(normal_of(step.plane), step.angle);
        break;
      case Kind::scale:
        frame = frame * CoordinateFrame::scale(step.values, step.center);
        break;
      case Kind::tilt:
        frame = frame * step.tilt;
        break;
    }
  }
  return frame;
}

}  // namespace feedscope::heidenhain
