#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/language/expression.h"
#include "core/program/text/scanner.h"

namespace feedscope::heidenhain {

/// A parameter as written: Q5, QL5, QR5, QS5.
struct QName {
  enum class Kind : std::uint8_t { global, local, remanent, text };
  Kind kind = Kind::global;
  int number = 0;
  std::uint32_t column = 0;  ///< 1-based

  std::string text() const;
};

/// Reads the name of a parameter; none, with the scanner unmoved, if none is next. Throws ReadFault
/// "parameter-number" for one that no control has.
std::optional<QName> take_parameter(Scanner& scanner);

/// Values of a program's parameters. QL ones belong to one program or called program.
class QParameters {
 public:
  std::optional<double> get(const QName& name) const;
  void set(const QName& name, double value);
  std::optional<double> global(int number) const { return get({QName::Kind::global, number}); }
  void set_global(int number, double value) { set({QName::Kind::global, number}, value); }

  const std::string& text(int number) const;
  void set_text(int number, std::string value);

  using Locals = std::vector<std::optional<double>>;
  /// Replaces the values of all QL. Returns the previous ones.
  Locals exchange_locals(Locals values);

 private:
  const std::vector<std::optional<double>>& values_of(QName::Kind kind) const;

  std::vector<std::optional<double>> globals_;
  std::vector<std::optional<double>> remanents_;
  Locals locals_;
  std::vector<std::string> texts_;
};

/// Formulas with Q parameters, angles in degrees.
class QFormulas : public ExpressionReader {
 public:
  /// Returns the value of a parameter that the program has not set.
  using Unset = std::function<double(const QName&)>;

  /// `parameters` outlives it.
  QFormulas(const QParameters& parameters, Unset unset);

  /// Reads a number or a parameter with its sign, after an address letter or as an operand of FN. Throws
  /// ReadFault "malformed-number" if none is next, "number-range" beyond +-1e9.
  double read_value(Scanner& scanner);

 private:
  std::optional<double> variable(Scanner& scanner) override;

  const QParameters& parameters_;
  Unset unset_;
};

}  // namespace feedscope::heidenhain
