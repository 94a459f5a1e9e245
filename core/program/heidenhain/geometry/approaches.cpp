#include "core/program/heidenhain/geometry/approaches.h"

#include <cmath>
#include <string_view>

#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

void Approaches::check_side(std::uint32_t column) const {
  if (modal_.side == 0) {
    report(Severity::warning, "approach-side", 0, column, [] {
      return Text{NC_("core", "an approach or departure without RL or RR"),
                  NC_("core", "the left side is assumed; write RL or RR")};
    });
  }
}

ApproachShape Approaches::shape_of(ApproachKind kind, const MotionWords& words, std::uint32_t column) const {
  ApproachShape shape;
  shape.kind = kind;
  shape.side = modal_.side == 0 ? 1 : modal_.side;
  const auto need = [&](const std::optional<double>& value, Translatable name) {
    if (!value || *value == 0) {
      throw ReadFault{"approach", column, message(NC_("core", "{} is missing or zero"), name),
                      NC_("core", "the approach or departure is skipped")};
    }
    return *value;
  };
  switch (kind) {
    case ApproachKind::tangent_line:
    case ApproachKind::normal_line:
      shape.length = std::abs(need(words.length, NC_("core", "its length LEN")));
      if (kind == ApproachKind::normal_line && modal_.side != 0) {
        // From the tool's edge.
        shape.length += modal_.tool_radius.value_or(0);
      }
      break;
    case ApproachKind::arc:
      shape.angle = std::abs(need(words.center_angle, NC_("core", "its angle CCA")));
      [[fallthrough]];
    case ApproachKind::line_and_arc:
      shape.radius = need(words.radius, NC_("core", "its radius R"));
      shape.tool_radius = modal_.side == 0 ? 0 : modal_.tool_radius.value_or(0);
      if (shape.radius < 0 && shape.radius + shape.tool_radius >= 0) {
        throw ReadFault{"approach", column,
                        message(NC_("core",
                                    "its radius R of {:.3f} mm on the other side is not larger than the tool "
                                    "radius, {:.3f} mm"),
                                shape.radius, shape.tool_radius),
                        NC_("core", "the approach or departure is skipped")};
      }
      break;
  }
  if (kind != ApproachKind::tangent_line) {
    check_side(column);
  }
  return shape;
}

void Approaches::approach(ApproachKind kind, bool polar, const MotionWords& words, std::uint32_t column) {
  m_functions_.start(words);
  ContourApproach approach;
  approach.travel = modal_.feed;
  approach.travel.rapid = motions_.was_rapid();
  feeds_.apply(words);
  tools_.select_side(words);
  approach.shape = shape_of(kind, words, column);
  if (polar && !targets_.has_pole(column)) {
    return;
  }
  approach.target = polar ? targets_.polar(words) : targets_.of(words);
  approach.feed = feeds_.of(words);
  if (kind == ApproachKind::line_and_arc) {
    approach.travel = approach.feed;
  }
  approach.side = modal_.side;
  approach.tool_radius = modal_.tool_radius;
  approach.place = contour_place(column, words.axis_bits() | bits_of(plane()));
  contour_.approach(approach);
  targets_.note_programmed_axes(words);
  motions_.set_was_rapid(false);
  m_functions_.finish(words, true);
}

void Approaches::soften(double radius, const MotionWords& words, std::uint32_t column) {
  if (!(radius > 0) || !contour_.soften_approach(radius, feeds_.alone(words))) {
    throw ReadFault{"approach", column,
                    NC_("core", "the preceding block is not a line to the first point of the contour"),
                    NC_("core", "the contour is approached straight")};
  }
  check_side(column);
}

void Approaches::depart(ApproachKind kind, bool polar, const MotionWords& words, std::uint32_t column,
                        const std::optional<ContourFeed>& curve_feed) {
  m_functions_.start(words);
  feeds_.apply(words);
  if (polar && !targets_.has_pole(column)) {
    return;
  }
  ContourDeparture departure;
  departure.shape = shape_of(kind, words, column);
  departure.target = polar ? targets_.polar(words) : targets_.of(words);
  departure.feed = feeds_.of(words);
  departure.curve_feed = curve_feed.value_or(departure.feed);
  departure.place = contour_place(column, words.axis_bits() | bits_of(plane()));
  contour_.depart(departure);
  modal_.side = 0;
  motions_.set_was_rapid(departure.feed.rapid);
  m_functions_.finish(words, true);
}

}  // namespace feedscope::heidenhain
