#include "core/program/heidenhain/geometry/coordinates.h"

#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

double checked_factor(double factor, std::uint32_t column) {
  constexpr double least = 0.000001;
  constexpr double most = 99.999999;
  if (!(factor >= least && factor <= most)) {
    throw ReadFault{"scale-factor", column,
                    message(NC_("core", "scaling factor {} is not from 0.000001 to 99.999999"), factor),
                    NC_("core", "the scaling is ignored")};
  }
  return factor;
}

void Coordinates::apply(std::uint32_t column) {
  end_contour(column);
  path().set_frame(transformations_.frame());
}

void Coordinates::set_tilt(const std::optional<CoordinateFrame>& tilt, std::uint32_t column) {
  if (tilt) {
    transformations_.tilt(*tilt);
  } else {
    transformations_.reset(Transformations::Kind::tilt);
  }
  apply(column);
}

void Coordinates::shift_datum(const std::array<OptionalWord, 3>& to, std::uint32_t column) {
  const bool under_tilt = transformations_.has_shift_under_tilt();
  const Vec3 before = transformations_.shift();
  for (int axis = 0; axis < 3; ++axis) {
    const OptionalWord& word = to[static_cast<std::size_t>(axis)];
    if (word.given) {
      transformations_.shift(axis, word.value, word.incremental);
    }
  }
  const Vec3 after = transformations_.shift();
  // Cancelling axis by axis before cancelling the tilt does no harm.
  const bool shifts = ((after - before).array() != 0 && after.array() != 0).any();
  if (under_tilt && shifts) {
    report(Severity::warning, "tilted-shift", 0, column, [] {
      return Text{NC_("core", "a datum shift replaces one that the plane was tilted about"),
                  NC_("core",
                      "it is applied in the untilted system; cancel the tilt before it, or shift in the "
                      "tilted plane only")};
    });
  }
}

void Coordinates::set_preset(const Message& what, bool keeps_transformations, std::uint32_t column) {
  if (!keeps_transformations) {
    // iTNC 530 and TNC 640 cycle programming, cycle 247.
    using Kind = Transformations::Kind;
    for (const Kind kind : {Kind::shift, Kind::mirror, Kind::rotation, Kind::scale}) {
      transformations_.reset(kind);
    }
    apply(column);
  }
  set_datum(what, column);
}

void Coordinates::set_datum(const Message& what, std::uint32_t column) const {
  end_contour(column);
  if (path().has_moved()) {
    report(Severity::warning, "work-offset", 0, column, [&] {
      return Text{message(NC_("core", "{} changes the datum after a motion"), what),
                  NC_("core", "datums of the machine are assumed as zero, so parts of the path overlap")};
    });
  }
}

}  // namespace feedscope::heidenhain
