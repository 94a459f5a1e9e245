#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/program/heidenhain/context.h"
#include "core/program/heidenhain/geometry/transformations.h"

namespace feedscope::heidenhain {

/// Datums and transformations; changes come into force by apply().
class Coordinates : private Part {
 public:
  explicit Coordinates(Context& context) : Part(context) {}

  Transformations& transformations() { return transformations_; }
  const Transformations& transformations() const { return transformations_; }
  /// Brings the transformations into force.
  void apply(std::uint32_t column);

  /// Tilts the working plane against the coordinates in force so far; none: ends the tilt.
  void set_tilt(const std::optional<CoordinateFrame>& tilt, std::uint32_t column);
  void shift_datum(const std::array<OptionalWord, 3>& to, std::uint32_t column);
  /// A datum that only the machine knows, named by `what`.
  void set_datum(const Message& what, std::uint32_t column) const;
  /// A datum of the machine; shift, mirror, rotation and scaling end unless `keeps_transformations`.
  void set_preset(const Message& what, bool keeps_transformations, std::uint32_t column);

 private:
  Transformations transformations_;
};

/// A scaling factor as the control accepts it. Throws ReadFault "scale-factor".
double checked_factor(double factor, std::uint32_t column);

}  // namespace feedscope::heidenhain
