#pragma once

#include <cstdint>
#include <string_view>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/compensation.h"
#include "core/program/sinumerik/geometry/coordinates.h"
#include "core/program/sinumerik/geometry/feeds.h"
#include "core/program/sinumerik/geometry/other_axis_words.h"
#include "core/program/sinumerik/geometry/path_modes.h"
#include "core/program/sinumerik/geometry/splines.h"
#include "core/program/sinumerik/geometry/targets.h"

namespace feedscope::sinumerik {

/// Applies G words, M words and functions without value: everything that is valid from this block on. Their
/// effects on the block itself are stored in BlockFunctions.
class ModalWords : private Part {
 public:
  /// Receivers of the functions; all outlive it.
  struct Parts {
    Feeds& feeds;
    Targets& targets;
    PathModes& path_modes;
    Splines& splines;
    Compensation& compensation;
    Coordinates& coordinates;
    OtherAxisWords& other_axes;
  };
  ModalWords(Context& context, const Parts& parts) : Part(context), parts_(parts) {}

  /// G and M by their numbers; `written`: with the letter.
  void apply_g(double number, std::uint32_t column, std::string_view written);
  void apply_m(double number);
  void apply(const Function& function, std::uint32_t column);

 private:
  void check_group(const Function& function, std::uint32_t column);
  void apply_action(const Function& function);
  void set_plane(Plane plane);
  void set_unit(Action action);

  Parts parts_;
};

}  // namespace feedscope::sinumerik
