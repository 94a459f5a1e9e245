#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/program/controls/klipper_line.h"
#include "core/program/controls/klipper_settings.h"
#include "core/program/text/source_text.h"

namespace feedscope {

/// Changes by M204 or SET_VELOCITY_LIMIT, valid from its line on. Source: Klipper, "G-Codes" (klipper3d.org).
struct KlipperLimitChange {
  std::optional<double> velocity;                ///< [mm/s]
  std::optional<double> acceleration;            ///< [mm/s2]
  std::optional<double> square_corner_velocity;  ///< [mm/s]
  std::optional<double> minimum_cruise_ratio;
  /// In older versions instead of the ratio: 1 - this / acceleration [mm/s2].
  std::optional<double> acceleration_to_deceleration;
  Message fault;  ///< reason why Klipper rejects the line; empty: accepted

  void apply(KlipperSettings& limits) const;
};

/// None if the line is another command.
std::optional<KlipperLimitChange> klipper_limit_change(const KlipperLine& line);

/// Limits in force at each line of a program that changes them.
class KlipperLimits {
 public:
  /// `initial` before the first change; `source` may be null.
  KlipperLimits(const KlipperSettings& initial, const SourceText* source);

  /// Settings at line `line`, counted from 1.
  const KlipperSettings& at(std::uint32_t line) const;

 private:
  struct Change {
    std::uint32_t line = 0;
    KlipperSettings limits;
  };
  std::vector<Change> changes_;  ///< in the order of the lines; the first at line 0
};

}  // namespace feedscope
