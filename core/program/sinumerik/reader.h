#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "core/program/reader.h"
#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/cycles/cycles.h"
#include "core/program/sinumerik/geometry/arcs.h"
#include "core/program/sinumerik/geometry/compensation.h"
#include "core/program/sinumerik/geometry/coordinates.h"
#include "core/program/sinumerik/geometry/corners.h"
#include "core/program/sinumerik/geometry/dwells.h"
#include "core/program/sinumerik/geometry/feeds.h"
#include "core/program/sinumerik/geometry/kept_modes.h"
#include "core/program/sinumerik/geometry/last_motion.h"
#include "core/program/sinumerik/geometry/machine_positions.h"
#include "core/program/sinumerik/geometry/motion.h"
#include "core/program/sinumerik/geometry/other_axis_words.h"
#include "core/program/sinumerik/geometry/path_modes.h"
#include "core/program/sinumerik/geometry/polynomials.h"
#include "core/program/sinumerik/geometry/positioning_axes.h"
#include "core/program/sinumerik/geometry/splines.h"
#include "core/program/sinumerik/geometry/targets.h"
#include "core/program/sinumerik/language/addresses.h"
#include "core/program/sinumerik/language/assignments.h"
#include "core/program/sinumerik/language/calls.h"
#include "core/program/sinumerik/language/definitions.h"
#include "core/program/sinumerik/language/flow.h"
#include "core/program/sinumerik/language/frame_variables.h"
#include "core/program/sinumerik/language/jumps.h"
#include "core/program/sinumerik/language/macros.h"
#include "core/program/sinumerik/language/modal_words.h"
#include "core/program/sinumerik/language/program_indexes.h"
#include "core/program/sinumerik/language/repeats.h"
#include "core/program/sinumerik/language/statements.h"
#include "core/program/sinumerik/language/subprograms.h"
#include "core/program/sinumerik/language/values.h"
#include "core/program/text/lexer.h"

namespace feedscope::sinumerik {

/// Reads programs of the Sinumerik 840D and similar controls; README.md in this folder lists the words. A
/// line becomes words (Lexer, Statements), the words modal state (ModalWords), motions and calls.
class SinumerikReader : public Reader {
 public:
  SinumerikReader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress);

 private:
  void run_line(std::string_view line) override;
  void run_out() override { calls_.run_out(); }
  void finish() override { splines_.finish(); }
  std::uint32_t first_word(std::string_view line) override;

  void run_head(std::string_view line);
  void run_block(const Block& block);
  void begin_block();
  /// Returns false for unreadable words.
  bool report_faults(const Block& block) const;
  void gather(const Block& block);
  bool run_statements(const Block& block);
  /// `sound`: the whole block is readable; otherwise it does not move.
  void execute_block(bool sound);
  void run_m_functions();
  void run_own_block();
  template <typename MakeText>
  void report(Severity severity, MessageCode code, int detail, std::uint32_t column, MakeText&& text) const {
    machining().report(severity, code, detail, context_.written(column), text);
  }

  Lexer lexer_{Brackets::statement};
  Context context_;
  Macros macros_;
  ProgramIndexes indexes_;
  LastMotion last_motion_;
  Values values_;
  Assignments assignments_;
  Feeds feeds_;
  Targets targets_;
  PathModes path_modes_;
  OtherAxisWords other_axes_;
  Splines splines_;
  Polynomials polynomials_;
  Arcs arcs_;
  Corners corners_;
  Compensation compensation_;
  Dwells dwells_;
  MachinePositions machine_positions_;
  PositioningAxes positioning_axes_;
  Coordinates coordinates_;
  FrameVariables frame_variables_;
  Motions motions_;
  Cycles cycles_;
  Jumps jumps_;
  Repeats repeats_;
  Flow flow_;
  KeptModes kept_modes_;
  Subprograms subprograms_;
  Calls calls_;
  ModalWords modal_words_;
  Definitions definitions_;
  Addresses addresses_;
  Statements statements_;
};

}  // namespace feedscope::sinumerik
