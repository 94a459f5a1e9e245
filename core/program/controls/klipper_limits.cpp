#include "core/program/controls/klipper_limits.h"

#include <algorithm>

namespace feedscope {
namespace {

/// Reads the numbers of one line; its fault is the first number that Klipper would reject.
class LimitWords {
 public:
  LimitWords(const KlipperLine& line, Message& fault) : line_(line), fault_(fault) {}

  std::optional<double> above_zero(std::string_view key) {
    return take(key, [](double value) { return value > 0; });
  }
  std::optional<double> from_zero(std::string_view key) {
    return take(key, [](double value) { return value >= 0; });
  }
  /// Reads a number from 0 to below 1.
  std::optional<double> ratio(std::string_view key) {
    return take(key, [](double value) { return value >= 0 && value < 1; });
  }

 private:
  template <typename Allowed>
  std::optional<double> take(std::string_view key, const Allowed& allowed) {
    if (!line_.has(key)) {
      return std::nullopt;
    }
    const std::optional<double> value = line_.number(key);
    if (value && allowed(*value)) {
      return value;
    }
    if (fault_.empty()) {
      fault_ = message(NC_("core", "invalid value of {}"), key);
    }
    return std::nullopt;
  }

  const KlipperLine& line_;
  Message& fault_;
};

/// M204 S, or the lower of P and T; P or T alone changes nothing.
KlipperLimitChange of_m204(const KlipperLine& line) {
  KlipperLimitChange change;
  LimitWords words(line, change.fault);
  if (line.has("S")) {
    change.acceleration = words.above_zero("S");
    return change;
  }
  const std::optional<double> print = words.above_zero("P");
  const std::optional<double> travel = words.above_zero("T");
  if (print && travel) {
    change.acceleration = std::min(*print, *travel);
  } else if (change.fault.empty()) {
    change.fault = NC_("core", "M204 needs S, or P and T");
  }
  return change;
}

/// Quick test: true if a line may contain one of the two commands.
bool may_change(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos &&
         std::string_view("MmSsNn").find(line[first]) != std::string_view::npos;
}

}  // namespace

void KlipperLimitChange::apply(KlipperSettings& limits) const {
  limits.max_velocity = velocity.value_or(limits.max_velocity);
  limits.max_acceleration = acceleration.value_or(limits.max_acceleration);
  limits.square_corner_velocity = square_corner_velocity.value_or(limits.square_corner_velocity);
  if (minimum_cruise_ratio) {
    limits.minimum_cruise_ratio = *minimum_cruise_ratio;
  } else if (acceleration_to_deceleration) {
    limits.minimum_cruise_ratio = 1 - std::min(1.0, *acceleration_to_deceleration / limits.max_acceleration);
  }
}

std::optional<KlipperLimitChange> klipper_limit_change(const KlipperLine& line) {
  if (line.command == "M204") {
    return of_m204(line);
  }
  if (line.command != "SET_VELOCITY_LIMIT") {
    return std::nullopt;
  }
  KlipperLimitChange change;
  LimitWords words(line, change.fault);
  change.velocity = words.above_zero("VELOCITY");
  change.acceleration = words.above_zero("ACCEL");
  change.square_corner_velocity = words.from_zero("SQUARE_CORNER_VELOCITY");
  change.minimum_cruise_ratio = words.ratio("MINIMUM_CRUISE_RATIO");
  change.acceleration_to_deceleration = words.above_zero("ACCEL_TO_DECEL");
  return change;
}

KlipperLimits::KlipperLimits(const KlipperSettings& initial, const SourceText* source) {
  changes_.push_back({0, initial});
  if (source == nullptr) {
    return;
  }
  for (std::uint32_t number = 1; number <= source->line_count(); ++number) {
    const std::string_view text = source->line(number);
    if (!may_change(text)) {
      continue;
    }
    const std::optional<KlipperLimitChange> change = klipper_limit_change(read_klipper_line(text));
    if (change && change->fault.empty()) {
      Change next{number, changes_.back().limits};
      change->apply(next.limits);
      changes_.push_back(next);
    }
  }
}

const KlipperSettings& KlipperLimits::at(std::uint32_t line) const {
  const auto behind = std::ranges::upper_bound(changes_, line, {}, &Change::line);
  return std::prev(behind)->limits;
}

}  // namespace feedscope
