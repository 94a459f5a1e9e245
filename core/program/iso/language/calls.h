#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/program/iso/context.h"
#include "core/program/iso/geometry/kept_modes.h"
#include "core/program/iso/language/subprograms.h"
#include "core/program/iso/language/variables.h"

namespace feedscope::iso {

/// Calls of subprograms and macros and returns from them: M97 to M99 and M198, O words, G65 to G67.
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

  /// Runs the calls of the current block, once it has moved; a block that is not `sound` only returns.
  void run(bool sound);
  /// G65, G66: the words of the block are arguments.
  void run_macro_call(const Block& block);
  /// G67.
  void cancel_modal_macro() { modal_macro_.reset(); }
  /// "o<label> call" with its arguments; `column` of the label.
  void call_sub(const std::string& label, std::uint32_t column, const std::vector<double>& arguments);
  /// Returns to the caller, or runs the call once more. Does nothing outside of calls.
  void leave();
  /// Fanuc: true if the program ends at the O number of the next one. `begun`: words have run before.
  bool ends_at_program_number(bool begun);

  /// An active repeat of LinuxCNC.
  struct Repeat {
    std::uint32_t line = 0;
    double left = 0;  ///< passes, including the current one
  };
  /// Repeats of the current call, innermost last.
  std::vector<Repeat>& repeats() { return frames_.back().repeats; }

 private:
  /// State of a call; the first is the program's own.
  struct Frame {
    std::uint32_t called_from = 0;               ///< line
    std::optional<Variables::Locals> arguments;  ///< none: the caller's local variables continue
    std::vector<Repeat> repeats;
    std::uint32_t program = 0;  ///< line of its own O number; 0: none
  };
  struct MacroCall {
    double program = 0;
    std::uint32_t column = 0;
    double times = 1;
    Subprogram found;
    Variables::Locals arguments{};
    std::size_t depth = 0;  ///< call depth of the G66
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
