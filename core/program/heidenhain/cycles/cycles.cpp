#include "core/program/heidenhain/cycles/cycles.h"

#include <algorithm>
#include <array>

namespace feedscope::heidenhain {

namespace {

constexpr int datum_setting = 247;

/// Contour geometry and data, orientation, load and vibration control.
constexpr auto motionless_cycles = std::to_array<int>({13, 14, 20, 239, 270, 332, 392});

}  // namespace

void Cycles::define(int number, std::string_view title, Scanner& parameters, std::uint32_t column) {
  patterns_.set_defaults(number);
  parameters_.read(number, parameters);
  if (PatternCycles::has(number)) {
    patterns_.run(number, cycle_, column);
  } else if (number == datum_setting) {
    coordinates_.set_preset(NC_("core", "cycle 247"), false, column);
  } else if (parameters_of_drilling(number).empty()) {
    skip(number, title, column);
  } else {
    set(number, Cycle::Kind::drilling);
  }
}

void Cycles::set(int number, Cycle::Kind kind, std::string_view program) {
  cycle_.number = number;
  cycle_.kind = kind;
  cycle_.program = program;
  calls_after_motions_ = false;
}

void Cycles::define_old_drilling(int number) {
  set(number, Cycle::Kind::old_drilling);
}

void Cycles::define_program(std::string_view program) {
  set(12, Cycle::Kind::program, program);
}

void Cycles::set_old_drilling(int number, int part, double value) {
  enum class Value { clearance, depth, infeed, dwell, feed, pitch, none };
  using V = Value;
  constexpr std::array pecking{V::clearance, V::depth, V::infeed, V::dwell, V::feed};
  constexpr std::array tapping{V::clearance, V::depth, V::dwell, V::feed, V::none};
  constexpr std::array rigid{V::clearance, V::depth, V::pitch, V::none, V::none};
  const auto& values = number == 1 ? pecking : number == 2 ? tapping : rigid;
  const Value which =
      part <= static_cast<int>(values.size()) ? values[static_cast<std::size_t>(part - 1)] : V::none;
  switch (which) {
    case V::clearance:
      cycle_.old.clearance = to_mm(value);
      break;
    case V::depth:
      cycle_.old.depth = to_mm(value);
      break;
    case V::infeed:
      cycle_.old.infeed = to_mm(value);
      break;
    case V::dwell:
      cycle_.old.dwell = value;
      break;
    case V::feed:
      cycle_.old.feed = modal_.to_feed(value);
      break;
    case V::pitch:
      cycle_.old.pitch = to_mm(value);
      break;
    case V::none:
      break;
  }
}

void Cycles::skip(int number, std::string_view title, std::uint32_t column) {
  const auto what = [&] {
    return title.empty() ? message(NC_("core", "cycle {} is not supported"), number)
                         : message(NC_("core", "cycle {} ({}) is not supported"), number, title);
  };
  if (std::find(motionless_cycles.begin(), motionless_cycles.end(), number) != motionless_cycles.end()) {
    report(Severity::info, "unread-cycle", number, column, [&] {
      return Text{what(), NC_("core", "it does not move by itself")};
    });
    return;
  }
  set(number, Cycle::Kind::unsupported);
  report(Severity::error, "unread-cycle", number, column, [&] {
    return Text{what(), NC_("core", "its motion is skipped wherever it is called")};
  });
}

void Cycles::call(std::uint32_t column, double surface_offset) {
  end_contour(column);
  const DrillingPlace place = drilling_place(context_);
  DrillingFault fault = DrillingFault::none;
  switch (cycle_.kind) {
    case Cycle::Kind::none:
      report(Severity::error, "cycle-call", 0, column, [] {
        return Text{NC_("core", "a cycle is called, but none is defined"),
                    NC_("core", "the call is skipped")};
      });
      break;
    case Cycle::Kind::drilling:
      if (const auto words = parameters_.drilling(cycle_.number, column)) {
        DrillingParameters shifted = *words;
        shifted.surface += surface_offset;
        fault = drill(cycle_.number, shifted, place);
      }
      break;
    case Cycle::Kind::old_drilling:
      fault = drill_old(cycle_.number, cycle_.old, place);
      break;
    case Cycle::Kind::program:
      calls_.call_program(cycle_.program, column);
      break;
    case Cycle::Kind::unsupported:
      break;
  }
  report_fault(context_, cycle_.number, fault, column);
}

}  // namespace feedscope::heidenhain
