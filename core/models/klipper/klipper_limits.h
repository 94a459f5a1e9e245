#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/models/klipper/klipper_line.h"
#include "core/models/klipper/klipper_settings.h"
#include "core/program/text/source_text.h"

namespace feedscope {

/// What M204 or SET_VELOCITY_LIMIT changes, from its line on. Source: Klipper, "G-Codes" (klipper3d.org).
struct KlipperLimitChange {
  std::optional<double> velocity;                ///< [mm/s]
  std::optional<double> acceleration;            ///< [mm/s2]
  std::optional<double> square_corner_velocity;  ///< [mm/s]
  std::optional<double> minimum_cruise_ratio;
  /// Of older versions, instead of the ratio: 1 - this / acceleration [mm/s2].
  std::optional<double> acceleration_to_deceleration;
  Message fault;  ///< why Klipper rejects the line; empty: it does not

  void apply(KlipperSettings& limits) const;
};

/// None where the line is another command.
std::optional<KlipperLimitChange> klipper_limit_change(const KlipperLine& line);

/// The limits in force at each line of a program that changes them on its way.
class KlipperLimits {
 public:
  /// `initial` before the first change; `source` may be null.
  KlipperLimits(const KlipperSettings& initial, const SourceText* source);

  /// At line `line`, from 1.
  const KlipperSettings& at(std::uint32_t line) const;

 private:
  struct Change {
    std::uint32_t line = 0;
    KlipperSettings limits;
  };
  std::vector<Change> changes_;  ///< in the order of the lines; the first at line 0
};

}  // namespace feedscope
