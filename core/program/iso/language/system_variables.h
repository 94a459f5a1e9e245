#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/program/iso/context.h"
#include "core/program/iso/geometry/coordinates.h"
#include "core/program/iso/language/variables.h"

namespace feedscope::iso {

/// Values of the variables in expressions: those set by the program, and those of the control, such as modal
/// state, position and work offsets.
class SystemVariables : public VariableSource, private Part {
 public:
  /// All outlive it.
  SystemVariables(Context& context, Coordinates& coordinates, Variables& variables)
      : Part(context), coordinates_(coordinates), variables_(variables) {}

  double numbered(std::uint32_t number, std::uint32_t column) override;
  double named(const std::string& name, std::uint32_t column) override;
  bool has_name(const std::string& name) const override;

  /// #number = value. Throws ReadFault for one that is read-only.
  void set(std::uint32_t number, double value, std::uint32_t column);

 private:
  /// Axis of a work offset.
  struct OffsetVariable {
    int key = 0;
    int axis = 0;
  };

  std::optional<OffsetVariable> offset_variable(std::uint32_t number) const;
  double unset(std::uint32_t number, std::uint32_t column) const;
  std::optional<double> built_in(std::uint32_t number) const;
  std::optional<double> built_in(std::string_view name) const;
  std::optional<double> fanuc_modal(std::uint32_t number) const;
  double position_of(int axis) const;
  double feed_word() const;
  void raise_alarm(double number, std::uint32_t column) const;

  Coordinates& coordinates_;
  Variables& variables_;
};

}  // namespace feedscope::iso
