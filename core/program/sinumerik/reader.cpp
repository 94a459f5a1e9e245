#include "core/program/sinumerik/reader.h"

#include "core/program/sinumerik/language/names.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

SinumerikReader::SinumerikReader(std::shared_ptr<const SourceText> source, const ReadOptions& options,
                                 Progress* progress)
    : Reader(std::move(source), options, progress),
      context_{.machining = machining()},
      values_(path(),
              [this](MessageCode code, int detail, std::uint32_t column, const Text& text) {
                // ENDFOR reads the line of FOR, whose columns differ from its own.
                const bool own = column <= lines().text().line(lines().line()).size();
                report(Severity::warning, code, detail, own ? column : 0, [&] { return text; });
              }),
      assignments_(values_),
      feeds_(context_),
      targets_(context_),
      path_modes_(context_, values_),
      other_axes_(context_),
      splines_(context_, targets_, last_motion_),
      polynomials_(context_, values_, last_motion_),
      arcs_(context_, targets_, last_motion_),
      corners_(context_, feeds_),
      compensation_(context_, values_),
      dwells_(context_, path_modes_),
      machine_positions_(context_, path_modes_),
      positioning_axes_(context_, values_, targets_, splines_, path_modes_, last_motion_),
      coordinates_(context_, targets_, splines_),
      frame_variables_(context_, values_, coordinates_, splines_, other_axes_),
      motions_(context_, {feeds_, targets_, path_modes_, splines_, polynomials_, arcs_, corners_,
                          machine_positions_, last_motion_}),
      cycles_(context_, {feeds_, targets_, path_modes_, splines_, coordinates_, last_motion_}),
      jumps_(context_, values_, splines_, indexes_),
      repeats_(context_, values_, splines_, indexes_, jumps_),
      flow_(context_, values_, assignments_, indexes_, jumps_),
      kept_modes_(context_,
                  {feeds_, targets_, path_modes_, compensation_, corners_, coordinates_, positioning_axes_}),
      subprograms_(lines(), indexes_, subprogram_files()),
      calls_(context_, {values_, splines_, cycles_, kept_modes_, subprograms_, repeats_}),
      modal_words_(context_,
                   {feeds_, targets_, path_modes_, splines_, compensation_, coordinates_, other_axes_}),
      definitions_(context_, values_, assignments_, frame_variables_, macros_, calls_),
      addresses_(context_, {values_, assignments_, modal_words_, compensation_, calls_, other_axes_}),
      statements_(context_, {values_, assignments_, modal_words_, addresses_, path_modes_, compensation_,
                             frame_variables_, other_axes_, polynomials_, positioning_axes_, definitions_,
                             jumps_, repeats_, flow_, calls_}) {
  context_.modal.inch = context_.modal.inch_feed = machining().unit.first() == LengthUnit::inch;
}

void SinumerikReader::run_line(std::string_view line) {
  context_.replaced.reset();
  if (repeats_.is_over(lines().line())) {
    return;
  }
  if (line.starts_with('%')) {
    run_head(line);
    return;
  }
  if (!macros_.empty()) {
    context_.replaced = macros_.replaced(line);
  }
  const Block& block = lexer_.read(context_.replaced ? std::string_view(context_.replaced->text) : line);
  const bool skipped = options().skip_deleted_blocks && block.delete_level > 0;
  if (!skipped && !(block.words.empty() && block.faults.empty() && block.statement == 0)) {
    calls_.note_words();
    run_block(block);
  }
  if (lines().line() == lines().text().line_count()) {
    repeats_.is_over(lines().line() + 1);
  }
}

/// "%_N_NAME_MPF" ends the previous program; the first main program of a file runs.
void SinumerikReader::run_head(std::string_view line) {
  if (calls_.words_met()) {
    calls_.end_or_return();
    return;
  }
  const ProgramIndex::Section* const main =
      lines().call_depth() == 0 ? indexes_.of(lines().text()).main_section() : nullptr;
  if (main != nullptr && main->first > lines().line() && !line.ends_with("_MPF")) {
    lines().jump_to(main->first);
  }
}

std::uint32_t SinumerikReader::first_word(std::string_view line) {
  if (line.starts_with('%')) {
    return 0;
  }
  const Block& block = lexer_.read(line);
  return block.words.empty() ? block.statement : block.words.front().column;
}

void SinumerikReader::run_block(const Block& block) {
  lines().count_block();
  begin_block();
  bool sound = report_faults(block);
  gather(block);
  if (block.statement > 0) {
    sound = run_statements(block) && sound;
  }
  execute_block(sound);
}

void SinumerikReader::begin_block() {
  context_.words.clear();
  context_.functions = {};
  calls_.begin_block();
  positioning_axes_.begin_block();
  other_axes_.begin_block();
  polynomials_.begin_block();
}

bool SinumerikReader::report_faults(const Block& block) const {
  for (const Fault& fault : block.faults) {
    const std::string_view written = block.text_of(fault);
    const bool range = fault.kind == FaultKind::number_range;
    report(Severity::error, range ? MessageCode("number-range") : MessageCode("malformed-number"), 0,
           fault.column, [&] {
             return Text{range ? message(NC_("core", "{} is above the largest number, 1000000000"),
                                         in_quotes(written))
                               : message(NC_("core", "{} has no valid number"), in_quotes(written)),
                         NC_("core", "the block does not move; correct the number")};
           });
  }
  return block.faults.empty();
}

void SinumerikReader::gather(const Block& block) {
  for (const Word& word : block.words) {
    addresses_.set(word, block.text_of(word));
  }
}

/// Returns false if they are unreadable.
bool SinumerikReader::run_statements(const Block& block) {
  try {
    Scanner scanner(without_comment(block.text), block.statement - 1);
    statements_.run(scanner);
    return true;
  } catch (const ReadFault& fault) {
    report(Severity::error, fault.code, 0, fault.column, [&] { return Text{fault.message, fault.hint}; });
    return false;
  }
}

void SinumerikReader::execute_block(bool sound) {
  const bool own = context_.functions.own_block != nullptr;
  feeds_.run();
  corners_.run_modal();
  if (!own) {
    compensation_.run();
  }
  run_m_functions();
  other_axes_.run(own || !sound);
  if (sound && own) {
    splines_.finish();
    run_own_block();
  } else if (sound) {
    const bool moved = motions_.run();
    if (positioning_axes_.has_positions()) {
      positioning_axes_.move(motions_.has_words());
    }
    if (moved) {
      calls_.run_modal();
    }
  }
  if (context_.functions.stop) {
    splines_.finish();
    path().pause(Pause::stop);
  }
  calls_.run_block();
}

/// Runs those that act before the block moves.
void SinumerikReader::run_m_functions() {
  const BlockFunctions& functions = context_.functions;
  if (!functions.tool_change && !functions.spindle_start && !functions.spindle_stop) {
    return;
  }
  splines_.finish();
  ToolRack& tools = machining().tools;
  if (functions.tool_change) {
    tools.change_to(compensation_.tool());
  }
  if (functions.spindle_stop) {
    tools.stop_spindle();
  }
  if (functions.spindle_start) {
    tools.start_spindle();
  }
}

/// Runs the function to which the block's coordinates belong.
void SinumerikReader::run_own_block() {
  const Function& own = *context_.functions.own_block;
  const Function* const motion = context_.functions[Group::motion];
  if (motion != nullptr && own.action != Action::dwell && own.action != Action::machine_axes) {
    report(Severity::error, "conflicting-g", kind_of(own.name), context_.functions.own_column, [&] {
      return Text{
          message(NC_("core", "{} and {} exclude each other in one block"), motion->name, own.name),
          message(NC_("core", "the coordinates are used for {} and nothing moves; write a block for each"),
                  own.name)};
    });
  }
  switch (own.action) {
    case Action::dwell:
      dwells_.run();
      break;
    case Action::machine_axes:
      machine_positions_.move();
      break;
    case Action::pole_from_position:
    case Action::pole_from_zero:
    case Action::pole_from_pole:
      targets_.set_pole();
      break;
    default:
      coordinates_.run();
  }
}

}  // namespace feedscope::sinumerik
