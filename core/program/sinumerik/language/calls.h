#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/cycles/cycles.h"
#include "core/program/sinumerik/geometry/kept_modes.h"
#include "core/program/sinumerik/geometry/splines.h"
#include "core/program/sinumerik/language/repeats.h"
#include "core/program/sinumerik/language/subprogram_call.h"
#include "core/program/sinumerik/language/subprograms.h"
#include "core/program/sinumerik/language/values.h"

namespace feedscope::sinumerik {

/// Calls of subprograms and cycles and returns from them: names, L, CALL, PCALL, EXTCALL, MCALL, RET, M17.
class Calls : private Part {
 public:
  /// Parts used by calls; all outlive it.
  struct Parts {
    Values& values;
    Splines& splines;
    Cycles& cycles;
    KeptModes& kept_modes;
    Subprograms& subprograms;
    Repeats& repeats;
  };
  Calls(Context& context, const Parts& parts) : Part(context), parts_(parts) {}

  /// Forgets the call of the previous block.
  void begin_block() { call_.reset(); }
  /// Runs the statement `name`, which has just been read; false if it is not one of this part. Throws
  /// ReadFault.
  bool run(std::string_view name, Scanner& scanner);
  /// Makes the block call `name`, or the call written here with its arguments. Throws ReadFault.
  void set(std::string name, std::uint32_t column);
  void read(Scanner& scanner) { call_ = read_call(scanner); }

  /// Runs the call of MCALL, after a motion of the block.
  void run_modal();
  /// Runs the call of the block and its return, at the block's end.
  void run_block();
  /// M2, M17, M30, RET: returns to the caller, or ends the program.
  void end_or_return();
  /// Call when the current text has no further line.
  void run_out() { leave(); }

  /// Arguments of the current call, and their use by PROC.
  struct Parameters {
    Arguments arguments;
    std::vector<std::pair<std::string, std::string>> returned;  ///< own variable, caller's: VAR parameters
    bool keeps_modes = false;                                   ///< PROC ... SAVE
  };
  /// nullptr in the program itself.
  Parameters* parameters() { return scopes_.empty() ? nullptr : &scopes_.back().parameters; }

  /// True if the current program or subprogram has had words, so that the next head ends it.
  bool words_met() const { return scopes_.empty() ? words_met_ : scopes_.back().words_met; }
  void note_words() { (scopes_.empty() ? words_met_ : scopes_.back().words_met) = true; }

 private:
  /// A running subprogram.
  struct Scope {
    Parameters parameters;
    bool words_met = false;
    bool ends_caller = false;  ///< the block of the call also contains M17 or M30
    KeptModes::Kept kept;      ///< of the caller
  };
  struct ModalCall {
    SubprogramCall call;
    std::size_t depth = 0;  ///< of calls
  };

  void run_ret(Scanner& scanner);
  void run_call(Scanner& scanner);
  void run_extcall(Scanner& scanner);
  void run_isocall(Scanner& scanner);
  void run_mcall(Scanner& scanner);
  void call_by_text(Scanner& scanner);
  SubprogramCall read_call(Scanner& scanner);
  Arguments read_arguments(Scanner& scanner);
  Argument read_argument(Scanner& scanner);
  bool run_cycle(const SubprogramCall& call);
  void run_subprogram(const SubprogramCall& call, std::uint32_t times);
  void enter(const SubprogramCall& call, const Subprogram& subprogram, std::uint32_t times);
  bool leave();
  void come_back();
  void return_values(const Parameters& parameters);

  Parts parts_;
  std::optional<SubprogramCall> call_;  ///< of the block
  std::optional<ModalCall> modal_call_;
  std::vector<Scope> scopes_;
  bool words_met_ = false;  ///< in the program itself
};

}  // namespace feedscope::sinumerik
