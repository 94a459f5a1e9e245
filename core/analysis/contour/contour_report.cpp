#include "core/analysis/contour/contour_report.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "core/analysis/contour/contour_search.h"
#include "core/analysis/run/tolerance_in_force.h"
#include "core/blend/junction.h"
#include "core/blend/path_rules.h"
#include "core/machine/contour_tolerance.h"
#include "core/program/text/block_number.h"

namespace feedscope {
namespace {

/// End of a block, where it meets a neighbour.
struct Junction {
  double distance = 0;  ///< of the place's programmed point along the block [mm]
  Vec3 in = Vec3::Zero();
  Vec3 out = Vec3::Zero();
  std::size_t neighbour = 0;

  double turn() const { return turn_angle(in, out); }
};

/// On an evenly cut corner of `turn` the nearest programmed point is error tan(turn / 2) before its end.
bool is_of_corner(const Junction& junction, double error) {
  constexpr double min_turn = 1e-3;  // [rad]
  constexpr double uneven = 2;
  const double turn = junction.turn();
  return turn > min_turn && junction.distance <= uneven * error * std::tan(std::min(turn / 2, 1.5));
}

double distance_along(const Toolpath& path, std::size_t segment, const Vec3& point) {
  const Segment& block = path.segments[segment];
  const double chord = (point - path.start_of(segment)).norm();
  if (block.kind != SegmentKind::arc) {
    return chord;
  }
  const Arc& arc = path.arc_of(block);
  const Vec3 from = point - arc.center;
  double angle = std::atan2(from.dot(arc.y), from.dot(arc.x));
  const double whole_turn = 2 * std::acos(-1.0);
  angle = angle < -1e-9 ? angle + whole_turn : angle;
  if (arc.rise.squaredNorm() > 0) {  // several turns: choose the one nearest in height
    const double height = from.dot(arc.rise) / arc.rise.squaredNorm();
    angle += whole_turn * std::round((height - angle) / whole_turn);
  }
  return std::clamp(angle, 0.0, arc.sweep) * arc.length_per_radian();
}

bool moves(const Toolpath& path, std::size_t segment) {
  return segment < path.segments.size() && path.segments[segment].kind != SegmentKind::dwell;
}

/// Contour tolerance at a place; in a corner the smaller one of both blocks.
double tolerance_at(const PathRules& rules, const ContourPlace& place, const ContourSpot& spot) {
  const double own = rules.tolerance(place.segment);
  if (spot.kind != ContourSpot::Kind::corner) {
    return own;
  }
  return std::min(own, rules.tolerance(spot.neighbour));
}

/// Sorts by error; equally bad places in order of the program.
void order(std::vector<ContourFinding>& findings) {
  constexpr double as_bad = 1e-5;  // [mm]
  const auto key = [](const ContourFinding& finding) {
    return std::pair(-std::round(finding.place.error / as_bad), finding.place.time);
  };
  std::ranges::sort(findings, std::ranges::less(), key);
}

}  // namespace

ContourSpot contour_spot(const Toolpath& programmed, const ContourPlace& place) {
  const Segment& block = programmed.segments[place.segment];
  ContourSpot spot;
  spot.length = block.length;
  const Vec3 offset = place.position - place.programmed;
  const double along = distance_along(programmed, place.segment, place.programmed);
  Junction junction{.distance = std::numeric_limits<double>::infinity()};
  if (moves(programmed, place.segment + 1)) {
    junction = {block.length - along, programmed.tangent_at_end(place.segment),
                programmed.tangent_at_start(place.segment + 1), place.segment + 1};
  }
  if (place.segment > 0 && moves(programmed, place.segment - 1) && along < junction.distance) {
    junction = {along, programmed.tangent_at_end(place.segment - 1),
                programmed.tangent_at_start(place.segment), place.segment - 1};
  }
  if (std::isfinite(junction.distance) && is_of_corner(junction, place.error)) {
    spot.kind = ContourSpot::Kind::corner;
    spot.turn = junction.turn();
    spot.neighbour = junction.neighbour;
    spot.inside = offset.dot(junction.out - junction.in) > 0;
  } else if (block.kind == SegmentKind::arc) {
    const Arc& arc = programmed.arc_of(block);
    const Vec3 inwards = arc.at(std::clamp(along, 0.0, arc.length())).d2;
    spot.kind = ContourSpot::Kind::arc;
    spot.radius = arc.radius;
    spot.inside = offset.dot(inwards) > 0;
  }
  return spot;
}

ContourReport contour_report(const Run& run, std::size_t places, Progress* progress) {
  const Trajectory& trajectory = *run.trajectory;
  const Toolpath& programmed = programmed_path(trajectory);
  const ContourErrors errors = contour_errors(
      trajectory, {.places = places, .bins = ContourBins::none, .spread = true, .cutting_only = true},
      progress);
  ContourReport report;
  report.largest = errors.largest;
  report.spread = errors.spread;
  report.own_tolerances = run.setup.model->guarantees(run.setup.settings).own_tolerances;
  report.program_tolerances = follows_program_tolerance(run.setup.settings);
  constexpr double found = 2 * ContourSearch::precision;  // of searches with other numbers of places
  if (run.summary.max_contour_error > errors.largest + found) {
    report.rapids = run.summary.max_contour_error;
  }
  std::optional<PathRules> rules;
  const auto tolerance = tolerance_in_force(run.input.feed_controls, run.setup);
  if (tolerance && tolerance->max > 0) {
    report.tolerance = {tolerance->min, tolerance->max};
    rules.emplace(programmed, run.setup.settings);
  }
  for (const ContourPlace& place : errors.worst) {
    const State state = trajectory.state(place.time);
    ContourFinding finding{place,
                           contour_spot(programmed, place),
                           block_number(run.input.program->source->line(place.line)),
                           state.speed,
                           state.programmed_feed,
                           state.cause,
                           std::nullopt};
    if (rules) {
      finding.tolerance = tolerance_at(*rules, place, finding.spot);
    }
    report.worst.push_back(std::move(finding));
  }
  order(report.worst);
  return report;
}

bool ContourReport::is_flat() const {
  constexpr double nearly_all = 0.99;
  constexpr double most_of_it = 0.9;
  return spread.in_plane >= nearly_all &&
         (worst.empty() || std::abs(worst.front().place.side) >= most_of_it * worst.front().place.error);
}

bool keeps_tolerance(double error, double tolerance) {
  constexpr double fitted = 1e-4;  // iterative models stop there
  return error <= tolerance * (1 + fitted) + ContourSearch::precision;
}

}  // namespace feedscope
