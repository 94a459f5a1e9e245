// The part of PathWriter that writes curves.
#include "core/program/path/curve_arcs.h"
#include "core/program/path/curve_lines.h"
#include "core/program/path/path_writer.h"

namespace feedscope {

Vec3 PathWriter::curve(const ParametricCurve& curve, double from, double to, std::uint32_t column) {
  const bool as_arcs = compensation_.is_off() && corners_.is_idle();
  log_.add(Severity::info, as_arcs ? "curve-as-arcs" : "curve-as-lines", 0,
           {place_.line, column, place_.file}, [&] {
             return as_arcs ? DiagnosticLog::Text{"a curve is read as arcs that touch each other, within "
                                                  "0.001 mm of it",
                                                  ""}
                            : DiagnosticLog::Text{"a curve under cutter compensation or at a rounded corner "
                                                  "is read as lines within 0.001 mm of it",
                                                  ""};
           });
  const Vec3 direction = as_arcs ? curve_as_arcs(curve, from, to) : curve_as_lines(curve, from, to);
  end_motion();
  return direction;
}

Vec3 PathWriter::curve_as_arcs(const ParametricCurve& curve, double from, double to) {
  const auto shown = [&](double parameter) -> CurvePlace {
    const CurvePlace place = curve(parameter);
    return {frame_.to_shown(place.point), frame_.turned(place.slope)};
  };
  const bool as_is = frame_.is_identity();
  const CurvePieces fitted = arcs_of_curve(as_is ? curve : ParametricCurve(shown), from, to);
  const double feed = feed_over(fitted.length);
  for (const CurvePiece& piece : fitted.pieces) {
    const bool is_last = &piece == &fitted.pieces.back();
    append(piece.is_arc ? Motion::arc : Motion::line,
           is_last ? curve(to).point
           : as_is ? piece.end
                   : frame_.to_programmed(piece.end),
           feed, {piece.center, piece.axis, 0});
  }
  const Vec3 direction =
      as_is ? fitted.end_direction : Vec3(frame_.to_programmed(shown_ + fitted.end_direction) - programmed_);
  return direction.isZero() ? direction : Vec3(direction.normalized());
}

Vec3 PathWriter::curve_as_lines(const ParametricCurve& curve, double from, double to) {
  const std::vector<Vec3> ends = lines_of_curve(curve, from, to);
  double length = 0;
  Vec3 before = programmed_;
  Vec3 direction = Vec3::Zero();
  for (const Vec3& end : ends) {
    const Vec3 way = end - before;
    length += way.norm();
    direction = way.norm() > 0 ? Vec3(way.normalized()) : direction;
    before = end;
  }
  const double feed = feed_over(length);
  for (const Vec3& end : ends) {
    append(Motion::line, end, feed);
  }
  return direction;
}

}  // namespace feedscope
