#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "core/program/reader.h"
#include "core/program/sinumerik/addresses.h"
#include "core/program/sinumerik/arcs.h"
#include "core/program/sinumerik/assignments.h"
#include "core/program/sinumerik/calls.h"
#include "core/program/sinumerik/compensation.h"
#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/coordinates.h"
#include "core/program/sinumerik/corners.h"
#include "core/program/sinumerik/cycles.h"
#include "core/program/sinumerik/definitions.h"
#include "core/program/sinumerik/dwells.h"
#include "core/program/sinumerik/feeds.h"
#include "core/program/sinumerik/flow.h"
#include "core/program/sinumerik/frame_variables.h"
#include "core/program/sinumerik/jumps.h"
#include "core/program/sinumerik/kept_modes.h"
#include "core/program/sinumerik/last_motion.h"
#include "core/program/sinumerik/machine_positions.h"
#include "core/program/sinumerik/macros.h"
#include "core/program/sinumerik/modal_words.h"
#include "core/program/sinumerik/motion.h"
#include "core/program/sinumerik/other_axis_words.h"
#include "core/program/sinumerik/path_modes.h"
#include "core/program/sinumerik/polynomials.h"
#include "core/program/sinumerik/positioning_axes.h"
#include "core/program/sinumerik/program_indexes.h"
#include "core/program/sinumerik/repeats.h"
#include "core/program/sinumerik/splines.h"
#include "core/program/sinumerik/statements.h"
#include "core/program/sinumerik/subprograms.h"
#include "core/program/sinumerik/targets.h"
#include "core/program/sinumerik/values.h"
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
