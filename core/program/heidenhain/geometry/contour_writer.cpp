#include "core/program/heidenhain/geometry/contour_writer.h"

#include "core/program/path/plane_points.h"

namespace feedscope::heidenhain {

using Text = DiagnosticLog::Text;

Vec3 ContourWriter::position() const {
  return approach_ ? approach_->target : held_ ? last_.target : path_.position();
}

std::optional<PlaneElement> ContourWriter::curve_of(const Vec3& start, const ContourElement& element) const {
  const bool is_arc = element.is_arc && element.radius == 0;
  if (is_arc && element.plane != plane_) {
    return std::nullopt;
  }
  const Vec2 from = in_plane(start, plane_);
  const Vec2 to = in_plane(element.target, plane_);
  if (!is_arc) {
    return PlaneElement::line(from, to);
  }
  const bool full = (to - from).norm() <= same_point;
  return PlaneElement::arc(from, to, in_plane(element.center, plane_), element.turn,
                           element.extra_turns + (full ? 1 : 0));
}

std::optional<Vec2> ContourWriter::direction() const {
  if (approach_) {
    // The start of the approach depends on the element that asks.
    return std::nullopt;
  }
  const std::optional<PlaneElement> curve = curve_of(last_start_, last_);
  const Vec2 along = curve ? curve->tangent_at_end() : Vec2::Zero();
  return along == Vec2::Zero() ? std::nullopt : std::optional(along);
}

void ContourWriter::add(const ContourElement& element) {
  if (approach_) {
    resolve_approach(element);
  } else if (corner_) {
    hand_corner_on();
  }
  write_held();
  last_ = element;
  last_start_ = path_.position();
  held_ = true;
}

void ContourWriter::flush() {
  if (approach_) {
    const ContourApproach approach = *approach_;
    approach_.reset();
    report_approach(approach.place, NC_("core", "no contour follows the approach"),
                    NC_("core", "a line to its first point is used; write a contour element after it"));
    go(approach.target, approach.feed, approach.place);
  }
  if (corner_) {
    report_corner(NC_("core", "no contour element follows in the next block"),
                  NC_("core", "the corner stays sharp; write the corner between two lines or arcs"));
    corner_.reset();
  }
  write_held();
}

void ContourWriter::write_held() {
  if (held_) {
    held_ = false;
    last_start_ = path_.position();
    write(last_);
  }
}

void ContourWriter::write(const ContourElement& element) {
  path_.begin_line(element.place.line, element.place.place);
  for (int axis = 0; axis < 3; ++axis) {
    if ((element.place.axes >> axis & 1U) != 0) {
      path_.program_axis(axis, (element.place.incremental >> axis & 1U) != 0);
    }
  }
  path_.set_feed_mode(element.feed.mode);
  path_.set_feed(element.feed.value);
  compensate(element);
  if (!element.is_arc) {
    if (element.feed.rapid) {
      path_.rapid(element.target);
    } else {
      path_.line(element.target);
    }
    return;
  }
  ArcRequest arc;
  arc.target = element.target;
  arc.center = element.center;
  arc.radius = element.radius;
  arc.axis = element.turn * normal_of(element.plane);
  arc.extra_turns = element.extra_turns;
  arc.column = element.place.place.column;
  if (element.radius != 0) {
    path_.arc_by_radius(arc);
  } else {
    path_.arc_by_center(arc);
  }
}

void ContourWriter::compensate(const ContourElement& element) {
  const double beside = element.side * element.tool_radius.value_or(0);
  if (beside == beside_) {
    return;
  }
  beside_ = beside;
  if (beside == 0) {
    path_.end_compensation();
  } else {
    path_.set_compensation(element.side > 0 ? ToolSide::left : ToolSide::right, *element.tool_radius,
                           {.corner = OutsideCorner::arc}, plane_, element.place.place.column);
  }
}

void ContourWriter::add_corner(const ContourCorner& corner) {
  if (corner_) {
    report_corner(NC_("core", "another rounding or chamfer follows"),
                  NC_("core", "the first one is skipped"));
  }
  corner_ = corner;
  if (!held_ || approach_) {
    report_corner(NC_("core", "the preceding block is not a contour element"),
                  NC_("core", "it is skipped; write the corner between two lines or arcs"));
    corner_.reset();
  }
}

void ContourWriter::report_corner(const Message& what, const Message& hint) {
  log_.add(Severity::error, "corner", 0, corner_->place.place, [&] {
    return Text{
        message(NC_("core", "the {} of {:.3f} mm: {}"),
                corner_->rounding ? NC_("core", "rounding") : NC_("core", "chamfer"), corner_->size, what),
        hint};
  });
}

/// The path cuts the corner once it knows the next element.
void ContourWriter::hand_corner_on() {
  CornerCut cut;
  cut.kind = corner_->rounding ? CornerCut::Kind::rounding : CornerCut::Kind::chamfer;
  cut.size = corner_->size;
  cut.line = corner_->place.line;
  cut.place = corner_->place.place;
  if (corner_->feed) {
    path_.set_feed_mode(corner_->feed->mode);
    path_.set_feed(corner_->feed->value);
    cut.feed = corner_->feed->rapid ? 0 : path_.feed_rate();
  }
  path_.cut_next_corner(cut, plane_);
  corner_.reset();
}

void ContourWriter::approach(const ContourApproach& approach) {
  flush();
  approach_ = approach;
}

bool ContourWriter::soften_approach(double radius, const std::optional<ContourFeed>& feed) {
  if (!held_ || last_.is_arc || approach_) {
    return false;
  }
  held_ = false;
  ContourApproach approach;
  approach.shape.kind = ApproachKind::line_and_arc;
  approach.shape.radius = radius;
  approach.shape.side = last_.side < 0 ? -1 : 1;
  approach.shape.tool_radius = last_.side == 0 ? 0 : last_.tool_radius.value_or(0);
  approach.target = last_.target;
  approach.travel = last_.feed;
  approach.feed = feed.value_or(last_.feed);
  approach.side = last_.side;
  approach.tool_radius = last_.tool_radius;
  approach.place = last_.place;
  approach_ = approach;
  return true;
}

void ContourWriter::report_approach(const BlockPlace& place, const Message& what, const Message& hint) {
  log_.add(Severity::error, "approach", 0, place.place, [&] { return Text{what, hint}; });
}

void ContourWriter::go(const Vec3& target, const ContourFeed& feed, const BlockPlace& place, int side,
                       std::optional<double> tool_radius) {
  const int normal = normal_axis(plane_);
  ContourElement step;
  step.feed = feed;
  step.place = place;
  step.side = side;
  step.tool_radius = tool_radius;
  if (std::abs(target[normal] - path_.position()[normal]) > same_point) {
    step.target = target;
    step.target[normal] = path_.position()[normal];
    write(step);
  }
  step.target = target;
  write(step);
}

ContourElement ContourWriter::curve_element(const ApproachPath& path, const Vec3& target) const {
  ContourElement element;
  element.target = target;
  element.is_arc = path.turn != 0;
  element.center = from_plane(path.center, plane_, target);
  element.plane = plane_;
  element.turn = path.turn;
  return element;
}

void ContourWriter::resolve_approach(const ContourElement& first) {
  const ContourApproach approach = *approach_;
  approach_.reset();
  const auto curve = curve_of(approach.target, first);
  if (!curve || curve->tangent_at_start() == Vec2::Zero()) {
    report_approach(approach.place,
                    NC_("core", "the contour after the approach has no direction in the plane at its start"),
                    NC_("core", "a line to its first point is used"));
    go(approach.target, approach.feed, approach.place);
    return;
  }
  // On a line square to the contour the tool arrives from its side; otherwise it is on its side from the
  // auxiliary point on.
  const bool square = approach.shape.kind == ApproachKind::normal_line;
  const int side_before = square ? 0 : approach.side;
  const auto path = approach_path(approach.shape, in_plane(path_.position(), plane_),
                                  in_plane(approach.target, plane_), curve->tangent_at_start());
  if (!path) {
    report_approach(
        approach.place,
        message(NC_("core", "the tool starts inside the approach arc of radius {:.3f} mm"),
                std::abs(approach.shape.radius)),
        NC_("core", "a line to the first point of the contour is used; start farther away or reduce R"));
    go(approach.target, approach.feed, approach.place);
    return;
  }
  go(from_plane(path->point, plane_, approach.target), approach.travel, approach.place, side_before,
     approach.tool_radius);
  ContourElement element = curve_element(*path, approach.target);
  element.feed = approach.feed;
  element.side = approach.side;
  element.tool_radius = approach.tool_radius;
  element.place = approach.place;
  write(element);
}

void ContourWriter::depart(const ContourDeparture& departure) {
  const std::optional<Vec2> along = direction();
  flush();
  const Vec3 from = path_.position();
  Vec3 end = from;
  end[normal_axis(plane_)] = departure.target[normal_axis(plane_)];
  const bool to_point = departure.shape.kind == ApproachKind::line_and_arc;
  std::optional<ApproachPath> path;
  if (!along) {
    report_approach(departure.place,
                    NC_("core", "the departure does not follow a contour in the working plane"),
                    NC_("core", "a line to its end is used"));
  } else {
    path =
        departure_path(departure.shape, in_plane(from, plane_), *along, in_plane(departure.target, plane_));
    if (!path) {
      report_approach(departure.place,
                      message(NC_("core", "the departure ends inside its arc of radius {:.3f} mm"),
                              std::abs(departure.shape.radius)),
                      NC_("core", "a line to its end is used; end farther away or reduce R"));
    }
  }
  if (path) {
    ContourElement element = curve_element(*path, from_plane(path->point, plane_, from));
    element.feed = departure.curve_feed;
    element.place = departure.place;
    element.side = departure.shape.kind == ApproachKind::normal_line ? 0 : last_.side;
    element.tool_radius = last_.tool_radius;
    write(element);
    last_ = element;
    last_start_ = from;
    end = from_plane(path->point, plane_, end);
  }
  if (to_point) {
    end = departure.target;
  }
  if ((end - path_.position()).norm() > same_point) {
    go(end, departure.feed, departure.place);
  }
}

}  // namespace feedscope::heidenhain
