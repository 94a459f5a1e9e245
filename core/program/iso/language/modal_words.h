#pragma once

#include "core/program/iso/context.h"
#include "core/program/iso/cycles/cycles.h"
#include "core/program/iso/geometry/kept_modes.h"
#include "core/program/iso/geometry/path_modes.h"
#include "core/program/iso/geometry/splines.h"
#include "core/program/iso/language/calls.h"

namespace feedscope::iso {

/// Applies the G and M words of a block, and F, S and T: everything that is valid from this block on. G words
/// that use the block's coordinates are stored in BlockWords::functions.
class ModalWords : private Part {
 public:
  /// All outlive it.
  ModalWords(Context& context, PathModes& path_modes, Cycles& cycles, Splines& splines, Calls& calls,
             KeptModes& kept_modes)
      : Part(context),
        path_modes_(path_modes),
        cycles_(cycles),
        splines_(splines),
        calls_(calls),
        kept_modes_(kept_modes) {}

  /// `word` of `block`.
  void apply_g(const Block& block, const Word& word);
  void apply_m(const Word& word);
  /// F and S, T.
  void apply_feed();
  void apply_tool();
  /// True if the program contains G90.1 or G91.1.
  bool names_centers() const { return names_centers_; }

 private:
  double length_of_feed(const Word& word) const;
  void switch_kinematics(int number, std::uint32_t column);
  void apply(const GCode& code, const Word& word);
  void check_group(const GCode& code, const Word& word);
  void add_function(int code, std::uint32_t column);

  PathModes& path_modes_;
  Cycles& cycles_;
  Splines& splines_;
  Calls& calls_;
  KeptModes& kept_modes_;
  bool names_centers_ = false;
};

}  // namespace feedscope::iso
