#include "tests/contract/motion.h"

#include <algorithm>

namespace feedscope::contract {
namespace {

Place place_of(const Toolpath& toolpath, const PathElement& element, bool in_corner) {
  if (in_corner && element.kind != ElementKind::filtered) {
    return Place::blend;
  }
  switch (element.kind) {
    case ElementKind::blend:
      return Place::blend;
    case ElementKind::arc:
      return Place::arc;
    case ElementKind::dwell:
      return Place::dwell;
    case ElementKind::line:
      return Place::line;
    case ElementKind::filtered:
      break;
  }
  return toolpath.segments[element.segment].kind == SegmentKind::arc ? Place::arc : Place::line;
}

}  // namespace

Motion::Motion(const Toolpath& toolpath, const Trajectory& run) : toolpath_(toolpath), run_(run) {
  const std::vector<PathElement>& elements = run.path().elements;
  std::vector<bool> in_corner(elements.size(), false);
  for (const BlendRecord& blend : run.blends()) {
    in_corner[blend.element] = true;
  }
  for (std::size_t i = 0; i < run.pieces().size(); ++i) {
    const Piece& piece = run.pieces()[i];
    const PathElement& element = elements[piece.element];
    parts_.push_back({i, piece.time, run.piece_end(i) - piece.time, piece.element, element.segment,
                      place_of(toolpath, element, in_corner[piece.element])});
  }
}

State Motion::at(const Part& part, double share) const {
  return run_.state_in_piece(part.number, share * part.duration);
}

std::size_t Motion::first_part_of(std::size_t segment) const {
  const auto found = std::partition_point(parts_.begin(), parts_.end(),
                                          [&](const Part& part) { return part.segment < segment; });
  return static_cast<std::size_t>(found - parts_.begin());
}

double Motion::element_start(const Part& part) const {
  return run_.path().elements[part.element].s;
}

double Motion::size(const Part& part) const {
  const PathElement& element = run_.path().elements[part.element];
  double size = element.start.norm() + element.end.norm() + element.length;
  if (element.kind == ElementKind::arc) {
    size += run_.path().arcs[element.geometry].radius;
  }
  return size;
}

double Motion::length(const Part& part) const {
  return run_.path().elements[part.element].length;
}

const FilteredMotion* Motion::filtered(const Part& part) const {
  const PathElement& element = run_.path().elements[part.element];
  return element.kind == ElementKind::filtered ? &run_.motions()[element.geometry] : nullptr;
}

double Motion::time_scale(const Part& part) const {
  const FilteredMotion* motion = filtered(part);
  return motion != nullptr ? std::min(part.duration, motion->filter_time()) : part.duration;
}

double Motion::memory(const Part& part) const {
  const FilteredMotion* motion = filtered(part);
  return motion != nullptr ? motion->delay() : 0;
}

double Motion::commanded_speed(const Part& part) const {
  const FilteredMotion* motion = filtered(part);
  return motion != nullptr ? motion->train().largest_feed : 0;
}

double Motion::open_length(const Part& part) const {
  constexpr double quadrature = 2e-8;  // of the length, and of what the largest speed covers
  const PathElement& element = run_.path().elements[part.element];
  const FilteredMotion* motion = filtered(part);
  return motion != nullptr
             ? quadrature * (element.s + element.length + commanded_speed(part) * motion->delay())
             : 0;
}

bool same_bits(const Trajectory& a, const Trajectory& b) {
  const auto same_piece = [](const Piece& p, const Piece& q) {
    return p.time == q.time && p.q == q.q && p.v == q.v && p.a == q.a && p.j == q.j &&
           p.element == q.element && p.cause == q.cause && p.law == q.law;
  };
  const auto same_element = [](const PathElement& p, const PathElement& q) {
    return p.start == q.start && p.end == q.end && p.s == q.s && p.length == q.length &&
           p.segment == q.segment && p.kind == q.kind;
  };
  return a.duration() == b.duration() &&
         std::equal(a.pieces().begin(), a.pieces().end(), b.pieces().begin(), b.pieces().end(), same_piece) &&
         std::equal(a.path().elements.begin(), a.path().elements.end(), b.path().elements.begin(),
                    b.path().elements.end(), same_element);
}

}  // namespace feedscope::contract
