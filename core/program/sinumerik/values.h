#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/program/path/path_writer.h"
#include "core/program/sinumerik/variables.h"
#include "core/program/text/expression.h"

namespace feedscope::sinumerik {

/// What FOR counts with: an R parameter or an element of a variable.
struct LoopCounter {
  int r = -1;
  Variable* variable = nullptr;  ///< used if `r` is negative
  std::size_t element = 0;
};

/// Reads the expressions of a program: numbers, R parameters, variables, texts.
class Values : public ExpressionReader {
 public:
  /// Says something about a value: code, kind, column, text. The code lives as long as the program.
  using Warn = std::function<void(std::string_view, int, std::uint32_t, DiagnosticLog::Text)>;

  /// `path` is asked where the tool is ($P_EP) and outlives this.
  Values(const PathWriter& path, Warn warn);

  Variables& variables() { return variables_; }

  /// The value of the longest expression from here on, as read() gives it; of a size that a word may have.
  /// Throws ReadFault "number-range" beyond +-1e9.
  double read_bounded(Scanner& scanner);
  static double bounded(double value, std::uint32_t column);
  /// A decimal number, signed or not, that is a whole value: at the line's end or before the next word. None,
  /// and nothing taken, for everything else. Most values are one, and this is many times as quick as read().
  static std::optional<double> plain_number(Scanner& scanner);
  /// Texts and values joined by "<<". Throws ReadFault.
  std::string read_text(Scanner& scanner);
  /// A text, or a variable that holds one, stands here.
  bool text_follows(Scanner scanner);

  /// One or more assignments to a variable whose name has just been read: index, "=" and the value, several
  /// for an array by SET and REP. Throws ReadFault.
  void assign(Scanner& scanner, Variable& variable, std::string_view name);
  /// The value behind "R5" or "R[5]", whose "R" has just been read; none and nothing taken if it is no R
  /// parameter.
  std::optional<int> r_number(Scanner& scanner);
  /// Values behind DEF's "=": one, or a list in brackets. Throws ReadFault.
  void initialise(Scanner& scanner, Variable& variable);
  /// The element behind the name: 0, or by its indices in "[...]". Throws ReadFault.
  std::size_t element(Scanner& scanner, const Variable& variable, std::string_view name);
  /// Throws ReadFault "syntax" if no variable stands here.
  LoopCounter read_counter(Scanner& scanner);
  double get(const LoopCounter& counter) const;
  void set(const LoopCounter& counter, double value);
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
  void set_list(Scanner& scanner, Variable& variable, std::size_t first);
  void repeat_one(Scanner& scanner, Variable& variable, std::size_t first);
  static void copy_on(Variable& variable, std::size_t first, double count);
  void set_one(Scanner& scanner, Variable& variable, std::size_t index);

  const PathWriter& path_;
  int text_depth_ = 0;
  Warn warn_;
  Variables variables_;
};

/// Takes `c`. Throws ReadFault "syntax" if something else stands here.
void require(Scanner& scanner, char c);
/// Moves behind what matches the bracket, '(' or '[', that stands here; quoted texts are left aside. Throws
/// ReadFault "syntax" if it is not closed.
void skip_brackets(Scanner& scanner);

}  // namespace feedscope::sinumerik
