#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/program/iso/context.h"
#include "core/program/iso/kept_modes.h"
#include "core/program/iso/subprograms.h"
#include "core/program/iso/variables.h"

namespace feedscope::iso {

/// Calls subprograms and macros and comes back from them: M97 to M99 and M198, O words, G65 to G67.
class Calls : private Part {
 public:
  /// All outlive it.
  Calls(Context& context, Variables& variables, KeptModes& kept_modes, FlowIndexes& indexes,
        Subprograms& subprograms)
      : Part(context),
        variables_(variables),
        kept_modes_(kept_modes),
        indexes_(indexes),
        subprograms_(subprograms) {}

  /// What the block in force calls, once it has moved; a block that is not `sound` only returns.
  void run(bool sound);
  /// G65, G66: the words of the block are arguments.
  void run_macro_call(const Block& block);
  /// G67.
  void cancel_modal_macro() { modal_macro_.reset(); }
  /// "o<label> call" with its arguments; `column` of the label.
  void call_sub(const std::string& label, std::uint32_t column, const std::vector<double>& arguments);
  /// Back to the caller, or the call once more. Nothing outside of calls.
  void leave();
  /// Fanuc: a program ends where the O number of the next one stands. `begun`: words have run before.
  bool ends_at_program_number(bool begun);

  /// A repeat of LinuxCNC that runs.
  struct Repeat {
    std::uint32_t line = 0;
    double left = 0;  ///< passes, the one that runs included
  };
  /// Those of the call in force, innermost last.
  std::vector<Repeat>& repeats() { return frames_.back().repeats; }

 private:
  /// What a call holds; the first is the program's own.
  struct Frame {
    std::uint32_t called_from = 0;               ///< line
    std::optional<Variables::Locals> arguments;  ///< none: the caller's local variables go on
    std::vector<Repeat> repeats;
    std::uint32_t program = 0;  ///< line of the O number that it began with; 0: none
  };
  struct MacroCall {
    double program = 0;
    std::uint32_t column = 0;
    double times = 1;
    Subprogram found;
    Variables::Locals arguments{};
    std::size_t depth = 0;  ///< of calls, at which G66 stands
  };

  void call_program(const Word& word);
  void call_blocks(const Word& word);
  void call_named_file(const Word& word);
  void return_to(const Word& word);
  MacroCall macro_call(const Block& block) const;
  void call(const MacroCall& macro) { enter(macro.found, macro.times, macro.arguments); }
  void enter(const Subprogram& subprogram, double times, const std::optional<Variables::Locals>& arguments);
  double repeats_of_block() const;
  void report_missing(const Message& what, const std::string& file, std::uint32_t column) const;

  Variables& variables_;
  KeptModes& kept_modes_;
  FlowIndexes& indexes_;
  Subprograms& subprograms_;
  std::vector<Frame> frames_{1};
  std::optional<MacroCall> modal_macro_;
};

}  // namespace feedscope::iso
