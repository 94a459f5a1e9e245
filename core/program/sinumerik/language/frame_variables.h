#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/coordinates.h"
#include "core/program/sinumerik/geometry/frame_value.h"
#include "core/program/sinumerik/geometry/other_axis_words.h"
#include "core/program/sinumerik/geometry/splines.h"
#include "core/program/sinumerik/language/values.h"

namespace feedscope::sinumerik {

/// Frame variables: $P_PFRAME, $P_IFRAME, $P_UIFR, and those of DEF FRAME; CTRANS, CROT, CSCALE, CMIRROR and
/// CFINE make their values.
class FrameVariables : private Part {
 public:
  /// All outlive it.
  FrameVariables(Context& context, Values& values, Coordinates& coordinates, Splines& splines,
                 OtherAxisWords& other_axes)
      : Part(context),
        values_(values),
        coordinates_(coordinates),
        splines_(splines),
        other_axes_(other_axes) {}

  /// Reads "$P_PFRAME=...", "$P_UIFR[1,X,TR]=..." after `name`, in upper case. False, with nothing taken, for
  /// other variables. Throws ReadFault.
  bool run_system_variable(Scanner& scanner, std::string_view name);
  /// The same for "F1=..." and "F1[X,TR]=..." of DEF FRAME.
  bool run_assignment(Scanner& scanner, std::string_view name);
  /// Reads the names after "DEF FRAME", with values or without. Throws ReadFault.
  void define(Scanner& scanner);

 private:
  void assign(Scanner& scanner, FrameValue& value, bool one_part);
  void set_part(FrameValue& value, FrameValue::Part part, std::string_view axis, double number,
                std::uint32_t column);
  void set_programmed_part(Scanner& scanner);
  int index(Scanner& scanner);
  FrameValue read(Scanner& scanner);
  FrameValue operand(Scanner& scanner);
  FrameValue system_operand(Scanner& scanner, std::uint32_t column);
  FrameValue frame_of_list(Scanner& scanner, FrameValue::Part part);

  Values& values_;
  Coordinates& coordinates_;
  Splines& splines_;
  OtherAxisWords& other_axes_;
  std::map<std::string, FrameValue> variables_;  ///< by upper-case name
};

}  // namespace feedscope::sinumerik
