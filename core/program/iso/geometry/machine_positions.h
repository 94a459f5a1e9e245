#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/program/iso/context.h"
#include "core/program/iso/geometry/targets.h"

namespace feedscope::iso {

/// Runs G28, G29, G30 and G53: moves to, at or from places of the machine; G28.1 and G30.1 store one.
class MachinePositions : private Part {
 public:
  /// Both outlive it.
  MachinePositions(Context& context, Targets& targets) : Part(context), targets_(targets) {}

  /// By ten times the G number.
  void run(int code, std::uint32_t column);

 private:
  void go_to_reference(int code, std::uint32_t column);
  AxisPlaces reference_of(int code) const;
  void store(int code);
  void go_to_machine_coordinates(std::uint32_t column);
  void return_from_reference();
  void report_levelling(std::uint32_t column) const;

  Targets& targets_;
  std::array<std::optional<AxisPlaces>, 2> stored_;  ///< by G28.1, by G30.1
  Vec3 intermediate_point_ = Vec3::Zero();           ///< of G28 and G30 [mm]
};

}  // namespace feedscope::iso
