#pragma once

#include <cstdint>
#include <string_view>

#include "core/program/heidenhain/cycles/pattern_cycles.h"
#include "core/program/heidenhain/geometry/coordinates.h"
#include "core/program/heidenhain/language/calls.h"

namespace feedscope::heidenhain {

/// Defines cycles and calls the last defined one.
class Cycles : private Part {
 public:
  /// All outlive it.
  Cycles(Context& context, CycleParameters& parameters, PatternCycles& patterns, Coordinates& coordinates,
         Calls& calls)
      : Part(context),
        parameters_(parameters),
        patterns_(patterns),
        coordinates_(coordinates),
        calls_(calls) {}

  /// The parameters are "Q200=2" words from the scanner on. Throws ReadFault.
  void define(int number, std::string_view title, Scanner& parameters, std::uint32_t column);
  /// Cycles 1, 2 and 17 of older programs.
  void define_old_drilling(int number);
  /// The value of its line or P word number `part`, as written.
  void set_old_drilling(int number, int part, double value);
  /// Cycle 12.
  void define_program(std::string_view program);
  /// A cycle that is not supported.
  void skip(int number, std::string_view title, std::uint32_t column);

  const Cycle& in_force() const { return cycle_; }
  /// `surface_offset` raises the surface of a drilling cycle [mm].
  void call(std::uint32_t column, double surface_offset = 0);

  /// M89: every motion calls it.
  bool is_modal() const { return calls_after_motions_; }
  void set_modal(bool modal) { calls_after_motions_ = modal; }

 private:
  /// Also ends the calls of M89.
  void set(int number, Cycle::Kind kind, std::string_view program = {});

  CycleParameters& parameters_;
  PatternCycles& patterns_;
  Coordinates& coordinates_;
  Calls& calls_;
  Cycle cycle_;
  bool calls_after_motions_ = false;  ///< M89
};

}  // namespace feedscope::heidenhain
