#include "core/toolpath/rotary_notes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/units.h"
#include "core/machine/axis_vector.h"

namespace feedscope {
namespace {

constexpr std::size_t most_notes = 10;  // of a kind

}  // namespace

void RotaryNotes::add(std::uint32_t line, MessageCode code, Message what, Message hint) {
  Diagnostic note;
  note.severity = Severity::info;
  note.line = line;
  note.code = std::string(code.text());
  note.message = std::move(what);
  note.hint = std::move(hint);
  faults_.push_back(std::move(note));
}

void RotaryNotes::add_unclear(std::uint32_t line, std::span<const RotaryPlaces> found,
                              std::span<const double> from, const RotaryAxis& first) {
  constexpr double large = 60 * units::pi / 180;
  constexpr double equal = 1e-6;  // [rad]
  const auto way_to = [&](const RotaryPlaces& places) {
    double way = 0;
    for (std::size_t k = 0; k < from.size(); ++k) {
      way = std::hypot(way, places.angles[k] - from[k]);  // as turn_to()
    }
    return way;
  };
  const double way = way_to(found.front());
  if (found.size() > 1 && way > large && std::abs(way_to(found[1]) - way) < equal && equals_++ < most_notes) {
    add(line, "rotary-position",
        NC_("core", "two positions of the rotary axes give the tool vector and are equally near"),
        NC_("core", "one of them is used; a control may choose the other"));
  }
  const double turn = std::abs(found.front().angles.front() - from.front());
  if (from.size() == 2 && turn > large && flips_++ < most_notes) {
    add(line, "rotary-way",
        message(NC_("core", "axis {} turns by {:.4g} degrees within one block for a tool vector"), first.name,
                units::to_deg(turn)),
        NC_("core",
            "a control may stop, limit the turn or go another way; near the singular position smaller steps "
            "of the tool vector, or a part that is clamped at a tilt, make it turn less"));
  }
}

void RotaryNotes::add_singular(const SegmentTurn& turn, const Segment& segment, const RotaryAxis& first) {
  constexpr double near = 10 * units::pi / 180;
  const std::size_t axis = known_axes.size() + rotary_names.find(first.name);
  const bool held = turn.at_tip && turn.tilt >= 0 && turn.tilt <= near && segment.feed > turn.limit.speed &&
                    turn.limit.axis == static_cast<std::int8_t>(axis);
  if (!held) {
    return;
  }
  std::vector<SingularPlace>& places = singular_places_;
  const bool goes_on = !places.empty() && last_singular_ + 1 == turn.segment;
  last_singular_ = turn.segment;
  if (!goes_on) {
    places.push_back(
        {segment.line, segment.line, segment.line, first.name, turn.tilt, turn.limit.speed, segment.feed});
  }
  SingularPlace& place = places.back();
  place.last_line = segment.line;
  if (turn.limit.speed / segment.feed < place.speed / place.feed) {
    place.line = segment.line;
    place.tilt = turn.tilt;
    place.speed = turn.limit.speed;
    place.feed = segment.feed;
  }
}

void RotaryNotes::report_singular() {
  std::vector<const SingularPlace*> slowest;
  for (const SingularPlace& place : singular_places_) {
    slowest.push_back(&place);
  }
  const std::size_t count = std::min(most_notes, slowest.size());
  std::ranges::partial_sort(slowest, slowest.begin() + static_cast<std::ptrdiff_t>(count), {},
                            [](const SingularPlace* place) { return place->speed / place->feed; });
  slowest.resize(count);
  std::ranges::sort(slowest);
  for (const SingularPlace* place : slowest) {
    add(place->line, "rotary-feed",
        message(NC_("core",
                    "axis {} holds the feed at {:.4g} of {:.4g} mm/min near its singular position: the tool "
                    "is {:.2g} degrees from its axis"),
                place->axis, units::to_mm_min(place->speed), units::to_mm_min(place->feed),
                units::to_deg(place->tilt)),
        message(NC_("core",
                    "lines {} to {}, one of {} such places; tilting the part by some degrees in the clamping "
                    "takes the path away from it"),
                place->first_line, place->last_line, singular_places_.size()));
  }
}

}  // namespace feedscope
