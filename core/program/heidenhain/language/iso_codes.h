#pragma once

#include <cstdint>

#include "core/program/heidenhain/geometry/iso_motions.h"
#include "core/program/heidenhain/language/parts.h"

namespace feedscope::heidenhain {

/// Runs the G codes of DIN/ISO blocks that are not motions.
class IsoCodes : private Part {
 public:
  /// Both outlive it.
  IsoCodes(Parts& parts, IsoMotions& motions) : Part(parts.context), parts_(parts), motions_(motions) {}

  /// Applies the modal codes: motions, units, sides, G90 and G91.
  void apply_modes(IsoBlock& block);
  /// Runs the other codes; true if one has used the coordinates of the block. Throws ReadFault.
  bool run(const IsoBlock& block);

 private:
  void run_code(int code, const IsoBlock& block);
  bool run_transformation(int code, const IsoBlock& block);
  bool run_corner(int code, const IsoBlock& block);
  void run_old_cycle(int number, const IsoBlock& block);
  void report_unsupported(int code, std::uint32_t column);

  Parts& parts_;
  IsoMotions& motions_;
};

}  // namespace feedscope::heidenhain
