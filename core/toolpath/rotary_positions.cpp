#include "core/toolpath/rotary_positions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/toolpath/turn_course.h"

namespace feedscope {
namespace {

constexpr double reached = 1e-9;  // [rad]

/// True if the program gives directions of the tool, not only angles of the axes of one machine.
bool says_directions(const std::vector<RotaryMove>& moves) {
  const auto cuts_by_axes = [](const RotaryMove& move) {
    return move.with_feed && !move.at_tip && !move.direction;
  };
  return std::ranges::none_of(moves, cuts_by_axes) &&
         std::ranges::any_of(moves, [](const RotaryMove& move) { return move.at_tip || move.direction; });
}

}  // namespace

PartOnMachine part_on_machine(const Machine& machine, const Settings& settings) {
  PartOnMachine part;
  part.known = true;
  for (int axis = 0; axis < 3; ++axis) {
    const char name = "xyz"[axis];
    if (const std::string key = fmt::format("part_angle_{}_deg", name); settings.has(key)) {
      const double angle = units::from_deg(settings.number(key));
      part.turn = Eigen::AngleAxisd(angle, Vec3::Unit(axis)).toRotationMatrix() * part.turn;
    }
    const std::string key = fmt::format("part_zero_{}_mm", name);
    part.known = part.known && settings.has(key);
    part.zero[axis] = settings.has(key) ? settings.number(key) : 0;
  }
  const std::string length = "tool_length_mm";
  part.known = part.known && (settings.has(length) || machine.kinematics.tool_length.has_value());
  part.tool_length =
      settings.has(length) ? settings.number(length) : machine.kinematics.tool_length.value_or(0);
  return part;
}

RotaryPositions::RotaryPositions(const Machine& machine, const KinematicChain& chain,
                                 const std::vector<RotaryMove>& moves, PartOnMachine& part,
                                 std::vector<Diagnostic>& faults, RotaryNotes& notes)
    : machine_(machine), chain_(chain), part_(part), faults_(faults), notes_(notes) {
  for (const std::size_t axis : chain.rotary()) {
    axes_.push_back(machine.kinematics.find(chain.axes()[axis].name));
  }
  if (part.turn.isIdentity()) {
    return;
  }
  if (!says_directions(moves)) {
    part.turn.setIdentity();
    fault(moves.front().line, Severity::warning, "rotary-position",
          NC_("core",
              "the part stays as programmed: the program sends the rotary axes of one machine to angles"),
          NC_("core",
              "part_angle_x_deg, _y_deg and _z_deg turn the part under programs with tool vectors, tilted "
              "planes or tool centre point control; post this one again"));
    return;
  }
  RotaryMove first;
  first.line = moves.front().line;
  at_ = angles_for(first, part.turn * tool_direction(chain_, at_));
}

void RotaryPositions::follow(const RotaryMove& move) {
  if (move.direction) {
    at_ = angles_for(move, part_.turn * *move.direction);
    posted_ = part_.turn.isIdentity() ? at_ : nearest(*move.direction, posted_);
    return;
  }
  posted_ = asked_by(move);
  at_ = part_.turn.isIdentity() ? posted_ : angles_for(move, part_.turn * tool_direction(chain_, posted_));
}

std::array<double, 3> RotaryPositions::asked_by(const RotaryMove& move) {
  std::array<double, 3> to = posted_;
  for (const RotaryAxis* axis : axes_) {
    const std::size_t place = rotary_place(axis->name);
    to[place] = move.to[place].value_or(to[place]);
    if (part_.turn.isIdentity() && (to[place] < axis->minimum.value_or(to[place]) - reached ||
                                    to[place] > axis->maximum.value_or(to[place]) + reached)) {
      fault(move.line, Severity::error, "rotary-travel",
            message(NC_("core", "axis {} goes to {:g} degrees, beyond its travel from {:g} to {:g}"),
                    axis->name, units::to_deg(to[place]), units::to_deg(axis->minimum.value_or(-HUGE_VAL)),
                    units::to_deg(axis->maximum.value_or(HUGE_VAL))),
            NC_("core", "the time of the whole way is counted; a control refuses the block"));
    }
  }
  return to;
}

/// Angles for `direction` on the machine, in which the part's turn is included.
std::array<double, 3> RotaryPositions::angles_for(const RotaryMove& move, const Vec3& direction) {
  std::array<double, 3> to = at_;
  std::vector<double> from;
  for (const RotaryAxis* axis : axes_) {
    from.push_back(at_[rotary_place(axis->name)]);
  }
  std::vector<RotaryPlaces> found = chain_.turn_to(direction, from);
  if (found.empty()) {
    const Vec3 asked = part_.turn.transpose() * direction;
    const bool by_vector = move.with_feed || move.with_rapid;
    const Message of = part_.turn.isIdentity()
                           ? (by_vector ? NC_("core", "the tool vector") : NC_("core", "the tilted plane"))
                           : (by_vector ? NC_("core", "the tool vector in the part as it is turned")
                                        : NC_("core", "the tilted plane in the part as it is turned"));
    fault(move.line, Severity::error, "rotary-direction",
          message(NC_("core",
                      "no position of the rotary axes of machine '{}' gives the tool the direction {:.4g}, "
                      "{:.4g}, {:.4g} of {}"),
                  machine_.id, asked.x(), asked.y(), asked.z(), of),
          NC_("core", "the rotary axes stay; tilt less, or choose another machine"));
    return to;
  }
  if (move.with_feed) {
    notes_.add_unclear(move.line, found, from, *axes_.front());
  }
  if (move.great_circle) {
    const auto is_led_to = [&](const RotaryPlaces& places) { return leads_to(places.angles); };
    std::stable_partition(found.begin(), found.end(), is_led_to);
  }
  const auto on_side = [&](const RotaryPlaces& places) {
    return move.side == 0 || move.side * places.angles.back() > -reached;
  };
  const auto asked = std::ranges::find_if(found, on_side);
  if (asked == found.end()) {
    fault(move.line, Severity::error, "rotary-direction",
          message(NC_("core",
                      "no position of the rotary axes with {} of axis {} gives the tool the direction of the "
                      "tilted plane within its travel"),
                  move.side > 0 ? NC_("core", "a positive angle") : NC_("core", "a negative angle"),
                  axes_.back()->name),
          NC_("core", "the other position is used; ask for the other side"));
  }
  const std::vector<double>& angles = asked == found.end() ? found.front().angles : asked->angles;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    to[rotary_place(axes_[k]->name)] = angles[k];
  }
  return to;
}

/// True if the axes reach the angles while the tool follows a great circle.
bool RotaryPositions::leads_to(const std::vector<double>& angles) const {
  SegmentTurn turn;
  turn.from = turn.to = at_;
  turn.great_circle = true;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    turn.to[rotary_place(axes_[k]->name)] = angles[k];
  }
  return TurnCourse(chain_, turn, 1).goes_on();
}

/// Angles that give the tool `direction`, or `from`.
std::array<double, 3> RotaryPositions::nearest(const Vec3& direction, std::array<double, 3> from) const {
  std::vector<double> before;
  for (const RotaryAxis* axis : axes_) {
    before.push_back(from[rotary_place(axis->name)]);
  }
  const std::vector<RotaryPlaces> found = chain_.turn_to(direction, before);
  for (std::size_t k = 0; !found.empty() && k < axes_.size(); ++k) {
    from[rotary_place(axes_[k]->name)] = found.front().angles[k];
  }
  return from;
}

void RotaryPositions::fault(std::uint32_t line, Severity severity, MessageCode code, Message what,
                            Message hint) {
  constexpr std::size_t most = 10;  // of a kind
  const auto same_kind = [&](const Diagnostic& other) {
    return other.code == code.text() && other.severity == severity;
  };
  if (static_cast<std::size_t>(std::ranges::count_if(faults_, same_kind)) >= most) {
    return;
  }
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.line = line;
  diagnostic.code = std::string(code.text());
  diagnostic.message = std::move(what);
  diagnostic.hint = std::move(hint);
  faults_.push_back(std::move(diagnostic));
}

}  // namespace feedscope
