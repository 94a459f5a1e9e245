#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/program/dialect.h"
#include "core/program/language/expression.h"

namespace feedscope::iso {

/// True for LinuxCNC and grbl, which share the same rules. Fanuc and all others differ in the rank of
/// operators, rounding, logic and undefined variables.
inline bool follows_linuxcnc(Dialect dialect) {
  return dialect == Dialect::linuxcnc || dialect == Dialect::grbl;
}

/// Value of an undefined Fanuc variable: zero in arithmetic, unequal to zero in EQ and NE; a word with it is
/// omitted.
double null_value();
bool is_null(double value);

/// Name of a LinuxCNC variable or O word: blanks omitted, lower case.
std::string normal_name(std::string_view name);

/// Values of the variables of an expression.
class VariableSource {
 public:
  virtual ~VariableSource() = default;
  /// Value of #number; may be the null value. Throws ReadFault.
  virtual double numbered(std::uint32_t number, std::uint32_t column) = 0;
  /// Value of #<name> for a normal name. Throws ReadFault if it has not been set.
  virtual double named(const std::string& name, std::uint32_t column) = 0;
  virtual bool has_name(const std::string& name) const = 0;
};

/// Expressions of Fanuc's macro B and of LinuxCNC: in square brackets, angles in degrees.
class Expression : public ExpressionReader {
 public:
  /// `variables` outlives it.
  Expression(Dialect dialect, VariableSource& variables);

  /// Reads the number after "#": digits, a variable or an expression in brackets. Throws ReadFault.
  std::uint32_t variable_number(Scanner& scanner);
  /// Reads "<name>"; empty if none is next. Throws ReadFault if it is not closed.
  std::string variable_name(Scanner& scanner);
  /// Fanuc's ROUND rounds to whole numbers, in the word of an axis to the smallest input step.
  void set_rounding_step(double step) { rounding_step_ = step; }

 private:
  std::optional<double> variable(Scanner& scanner) override;
  double arc_tangent(Scanner& scanner);
  /// Angle of ATAN with two values: from 0 to 360 degrees on a Fanuc, from -180 to 180 in LinuxCNC.
  double direction(double rise, double run) const;
  double exists(Scanner& scanner);

  VariableSource& variables_;
  bool linuxcnc_;
  double rounding_step_ = 1;
};

}  // namespace feedscope::iso
