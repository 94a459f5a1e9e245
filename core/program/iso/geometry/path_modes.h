#pragma once

#include <optional>
#include <string_view>

#include "core/program/iso/context.h"
#include "core/program/path_control.h"

namespace feedscope::iso {

/// Sets the path's PathControl by exact stops, path modes and look-ahead of a program: G5 P, G5.1 Q, G8 P,
/// G9, G61 to G64, G187.
class PathModes : private Part {
 public:
  explicit PathModes(Context& context) : Part(context) {}

  /// G9 applies to the block only.
  void apply(const GCode& code);

 private:
  std::optional<double> tolerance(char letter, std::string_view of) const;
  void set_tolerances(PathControl& control) const;
  void report_mode(char letter, Translatable of) const;
  void report_smooth_interpolation() const;
};

}  // namespace feedscope::iso
