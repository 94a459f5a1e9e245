#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/program/language/expression.h"
#include "core/program/path/path_writer.h"
#include "core/program/sinumerik/language/scanning.h"
#include "core/program/sinumerik/language/variables.h"

namespace feedscope::sinumerik {

/// Reads the expressions of a program: numbers, R parameters, variables, texts.
class Values : public ExpressionReader {
 public:
  /// Reports something about a value: code, kind, column, text. The code lives as long as the program.
  using Warn = std::function<void(MessageCode, int, std::uint32_t, DiagnosticLog::Text)>;

  /// `path` gives the position of the tool ($P_EP) and outlives this.
  Values(const PathWriter& path, Warn warn);

  Variables& variables() { return variables_; }

  /// Value of the longest expression from here on, like read(), within the range of words. Throws ReadFault
  /// "number-range" beyond +-1e9.
  double read_bounded(Scanner& scanner);
  static double bounded(double value, std::uint32_t column);
  /// Reads a decimal number, signed or not, that is the whole value: at the line's end or before the next
  /// word. None, with nothing taken, for everything else. Most values are such numbers, and this is many
  /// times as fast as read().
  static std::optional<double> plain_number(Scanner& scanner);
  /// Texts and values joined by "<<". Throws ReadFault.
  std::string read_text(Scanner& scanner);
  /// True if a text or a variable with a text is next.
  bool text_follows(Scanner scanner);

  /// The number of "R5" or "R[5]" after its "R"; none, with nothing taken, if it is not an R parameter.
  std::optional<int> r_number(Scanner& scanner);
  /// The element that follows a name: 0, or by its indices in "[...]". Throws ReadFault.
  std::size_t element(Scanner& scanner, const Variable& variable, std::string_view name);
  /// Skips index, arguments and value after a name. Throws ReadFault.
  void skip(Scanner& scanner);
  /// "[n]", "[n,m]" of a definition. Throws ReadFault.
  std::array<std::size_t, 3> dimensions(Scanner& scanner);

 protected:
  std::optional<double> variable(Scanner& scanner) override;

 private:
  std::optional<double> named(Scanner& scanner);
  std::optional<double> text_comparison(Scanner& scanner);
  double system_variable(Scanner& scanner);
  double quoted_number(Scanner& scanner);
  double r_value(int number, std::uint32_t column);
  double bound(Scanner& scanner);
  std::string text_operand(Scanner& scanner);

  const PathWriter& path_;
  int text_depth_ = 0;
  Warn warn_;
  Variables variables_;
};

}  // namespace feedscope::sinumerik
