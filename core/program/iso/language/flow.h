#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/program/iso/context.h"
#include "core/program/iso/language/calls.h"
#include "core/program/iso/language/expression.h"
#include "core/program/iso/language/flow_indexes.h"

namespace feedscope::iso {

/// Runs jumps, branches and loops: O words of LinuxCNC, macro statements of Fanuc.
class Flow : private Part {
 public:
  /// Runs words and assignments that follow a condition, up to the end of the line.
  using RunWords = std::function<void(Scanner&)>;

  /// All outlive it.
  Flow(Context& context, Expression& expression, Variables& variables, Calls& calls, FlowIndexes& indexes,
       RunWords run_words)
      : Part(context),
        expression_(expression),
        variables_(variables),
        calls_(calls),
        indexes_(indexes),
        run_words_(std::move(run_words)) {}

  /// True if the line is a statement of program flow (GOTO, IF, WHILE, O words). `line`: its plain words;
  /// `scan`: the rest of the line. Throws ReadFault.
  bool run(const Block& line, Scanner& scan);

 private:
  using Statement = FlowIndex::Statement;

  bool run_o_word(const Block& line, Scanner& scan);
  void run_o_word(FlowWord word, const std::string& label, std::uint32_t column, Scanner& scan);
  void call(const std::string& label, std::uint32_t column, Scanner& scan);
  void return_from_sub(Scanner& scan);
  bool run_macro_statement(Scanner& scan);
  bool run_macro_loop(Scanner& scan);
  bool run_macro_branch(Scanner& scan);
  bool run_output(Scanner& scan);
  void run_macro_if(Scanner& scan);
  void go_to(Scanner& scan);
  /// An unreadable condition is reported and false.
  bool condition(Scanner& scan);
  /// Reports words that are left after a statement.
  void report_rest(Scanner& scan) const;
  void report_nested_subs(const Statement& statement) const;
  /// Statement of the current line, as `written` in column `column`. Throws ReadFault if its counterpart is
  /// `missing`.
  const Statement& paired_statement(std::string_view written, const Message& missing, std::uint32_t column);
  void begin_branch(bool holds, const Statement& statement);
  void begin_loop(bool holds, const Statement& statement);
  void begin_repeat(Scanner& scan, const Statement& statement);
  void end_repeat(const Statement& statement);
  void leave_loop(bool for_good, const Statement& loop);
  const FlowIndex& index() { return indexes_.of(lines().text()); }

  Expression& expression_;
  Variables& variables_;
  Calls& calls_;
  FlowIndexes& indexes_;
  RunWords run_words_;
  std::uint32_t tested_branch_ = 0;  ///< line of an "elseif" or "else" to which an if jumps; 0: none
};

}  // namespace feedscope::iso
