#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "core/program/iso/context.h"
#include "core/program/iso/cycles/cycles.h"
#include "core/program/iso/geometry/compensation.h"
#include "core/program/iso/geometry/coordinates.h"
#include "core/program/iso/geometry/dwells.h"
#include "core/program/iso/geometry/kept_modes.h"
#include "core/program/iso/geometry/machine_positions.h"
#include "core/program/iso/geometry/motion.h"
#include "core/program/iso/geometry/path_modes.h"
#include "core/program/iso/geometry/splines.h"
#include "core/program/iso/language/calls.h"
#include "core/program/iso/language/flow.h"
#include "core/program/iso/language/modal_words.h"
#include "core/program/iso/language/statements.h"
#include "core/program/iso/language/word_checks.h"
#include "core/program/reader.h"

namespace feedscope::iso {

/// Reads the words shared by ISO controls, and Fanuc, LinuxCNC and grbl; README.md next to program.h lists
/// the words. A line becomes words (Lexer, Statements), the words modal state (ModalWords), functions and
/// motions.
class IsoReader : public Reader {
 public:
  /// `options.dialect` selects one of them; none: Dialect::iso. `absolute_centers`: I J K are positions until
  /// the program sets otherwise (G91.1), a parameter of some controls.
  IsoReader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress,
            bool absolute_centers = false);

  /// After read(): true if most arcs by a centre do not fit and the program does not define the meaning of
  /// its I J K.
  bool doubts_centers() const;
  /// After read(): true if every arc by a centre fits.
  bool centers_fit() const { return path().centers().misfits == 0; }

 private:
  void run_line(std::string_view line) override;
  std::uint32_t first_word(std::string_view line) override;
  void run_out() override { calls_.leave(); }
  void finish() override { splines_.finish(); }

  /// True if "%" follows.
  bool run_statement(const Block& line);
  /// Returns false if the line has none.
  bool report_klipper_command(const Scanner& scan);
  void run_words(Scanner& scan);
  /// `readable`: false for a block with unreadable words; it does not move.
  void run_block(const Block& block, bool readable);
  void gather(const Block& block);
  void run_functions();
  void run_function(int code, std::uint32_t column);
  void set_data(std::uint32_t column);
  /// True for a line whose words are none of the dialect; it is handled.
  bool is_no_block(const Block& block);
  bool is_grbl_command(const Block& block);

  Lexer lexer_;
  Lexer argument_lexer_;  ///< for arguments of macros
  Context context_;
  Variables variables_;
  FlowIndexes indexes_;
  Subprograms subprograms_;
  Targets targets_;
  Coordinates coordinates_;
  MachinePositions machine_positions_;
  Compensation compensation_;
  PathModes path_modes_;
  Cycles cycles_;
  Splines splines_;
  Dwells dwells_;
  Motions motions_;
  KeptModes kept_modes_;
  Calls calls_;
  ModalWords modal_words_;
  WordChecks checks_;
  SystemVariables system_variables_;
  Expression expression_;
  Statements statements_;
  Flow flow_;
  bool has_words_ = false;  ///< once words have run, "%" ends the program
};

}  // namespace feedscope::iso
