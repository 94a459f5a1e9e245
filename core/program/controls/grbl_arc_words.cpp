#include "core/program/controls/grbl_arc_words.h"

#include <cmath>

namespace feedscope {
namespace {

std::optional<GrblError> read_radius(float radius, GrblArc& arc, float x, float y) {
  if (x == 0 && y == 0) {
    return GrblError{33, Message::as_written("R")};
  }
  const float square = 4.0F * radius * radius - x * x - y * y;
  if (square < 0) {
    return GrblError{34, Message::as_written("R")};
  }
  const float side = (arc.clockwise == (radius < 0) ? 1.0F : -1.0F) * std::sqrt(square) / std::hypot(x, y);
  arc.to_center = {0.5F * (x - y * side), 0.5F * (y + x * side)};
  arc.radius = std::fabs(radius);
  return std::nullopt;
}

std::optional<GrblError> check_end_radius(const GrblArc& arc, float x, float y) {
  constexpr float may_differ = 0.005F;  // [mm]
  constexpr float at_most = 0.5F;       // [mm]
  constexpr float share = 0.001F;
  const float at_end = std::hypot(x - arc.to_center[0], y - arc.to_center[1]);
  const float difference = std::fabs(at_end - arc.radius);
  if (difference > may_differ && (difference > at_most || difference > share * arc.radius)) {
    return GrblError{33,
                     message(NC_("core", "radius {} mm at its start, {} mm at its end"), arc.radius, at_end)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<GrblError> read_arc_words(const GrblLine& line, float unit, GrblArc& arc, std::string& used) {
  const auto letter = [](char first, std::size_t axis) {
    return static_cast<char>(first + static_cast<char>(axis));
  };
  const auto [a, b, third] = arc.axes;
  if (!line.has(letter('X', a)) && !line.has(letter('X', b))) {
    return GrblError{26, Message::as_written("arc")};
  }
  const float x = arc.end[a] - arc.start[a];
  const float y = arc.end[b] - arc.start[b];
  if (const std::optional<float>& word = line.value('R')) {
    used += 'R';
    return read_radius(*word * unit, arc, x, y);
  }
  const std::optional<float>& first = line.value(letter('I', a));
  const std::optional<float>& second = line.value(letter('I', b));
  used += "IJK";
  if (!first && !second) {
    return GrblError{35, Message::as_written("arc")};
  }
  arc.to_center = {first.value_or(0) * unit, second.value_or(0) * unit};
  arc.radius = std::hypot(arc.to_center[0], arc.to_center[1]);
  return check_end_radius(arc, x, y);
}

}  // namespace feedscope
