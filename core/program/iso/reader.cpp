#include "core/program/iso/reader.h"

#include <algorithm>
#include <cmath>

#include "core/program/iso/language/faults.h"
#include "core/program/iso/language/printer_words.h"
#include "core/program/text/message.h"

namespace feedscope::iso {

namespace {

/// The arguments of a macro call may have E after a number, "K1.E5.".
bool calls_macro(const Block& block) {
  return std::any_of(block.words.begin(), block.words.end(), [](const Word& word) {
    return word.letter == 'G' && (word.value == 65 || word.value == 66);
  });
}

/// "M117 Layer 3": the rest is text for the operator of a printer.
bool ends_in_text(const Block& block) {
  return !block.words.empty() && block.words.back().letter == 'M' &&
         (block.words.back().value == 117 || block.words.back().value == 118);
}

}  // namespace

IsoReader::IsoReader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress,
                     bool absolute_centers)
    : Reader(std::move(source), options, progress),
      context_{machining(), options.dialect.value_or(Dialect::iso)},
      variables_(context_.dialect),
      indexes_(options.skip_deleted_blocks),
      subprograms_(lines(), indexes_, subprogram_files()),
      targets_(context_),
      coordinates_(context_, targets_),
      machine_positions_(context_, targets_),
      compensation_(context_),
      path_modes_(context_),
      cycles_(context_, targets_),
      splines_(context_, targets_),
      dwells_(context_),
      motions_(context_, targets_, cycles_, splines_),
      kept_modes_(context_, coordinates_),
      calls_(context_, variables_, kept_modes_, indexes_, subprograms_),
      modal_words_(context_, path_modes_, cycles_, splines_, calls_, kept_modes_),
      checks_(context_),
      system_variables_(context_, coordinates_, variables_),
      expression_(context_.dialect, system_variables_),
      statements_(context_, expression_, system_variables_, variables_),
      flow_(context_, expression_, variables_, calls_, indexes_, [this](Scanner& scan) { run_words(scan); }) {
  context_.modal.absolute_centers = absolute_centers;
  context_.modal.inch = machining().unit.first() == LengthUnit::inch;
  argument_lexer_.take_e_as_word();
}

bool IsoReader::doubts_centers() const {
  // A single wrong centre may happen to fit as a position.
  constexpr std::uint64_t fewest = 3;
  const PathWriter::CenterCount& centers = path().centers();
  const bool has_parameter = !follows_linuxcnc(context_.dialect);
  return has_parameter && !modal_words_.names_centers() && centers.misfits >= fewest &&
         2 * centers.misfits > centers.arcs;
}

void IsoReader::run_line(std::string_view line) {
  const Block& as_words = lexer_.read(line);
  const Block& block =
      !as_words.faults.empty() && calls_macro(as_words) ? argument_lexer_.read(line) : as_words;
  const bool skipped = options().skip_deleted_blocks && block.delete_level > 0;
  const std::size_t depth = lines().call_depth();
  bool percent = block.percent > 0;
  if (!skipped && block.statement > 0) {
    lines().count_block();
    percent = run_statement(block);
  } else if (!skipped && !(block.words.empty() && block.faults.empty())) {
    lines().count_block();
    if (!is_no_block(block)) {
      run_block(block, true);
    }
  }
  if (percent && has_words_ && lines().call_depth() == depth) {
    depth > 0 ? calls_.leave() : lines().end_program();
  }
}

bool IsoReader::run_statement(const Block& line) {
  Scanner scan = statements_.begin(line);
  if (flow_.run(line, scan)) {
    has_words_ = true;
    return false;
  }
  if (context_.dialect == Dialect::grbl && report_klipper_command(scan)) {
    return false;
  }
  statements_.keep_words(line);
  if (ends_in_text(line)) {
    run_block(line, true);
    return false;
  }
  run_words(scan);
  return scan.peek() == '%';
}

bool IsoReader::report_klipper_command(const Scanner& scan) {
  const std::string_view name = klipper_command(scan.text());
  if (name.empty()) {
    return false;
  }
  const bool limits = letters::same(name, "SET_VELOCITY_LIMIT");
  machining().report(limits ? Severity::info : Severity::warning, "unread-statement", limits ? 2 : 3, 1, [&] {
    return limits ? Text{NC_("core", "SET_VELOCITY_LIMIT is a command of Klipper"),
                         NC_("core", "only the model klipper follows it")}
                  : Text{message(NC_("core", "{} is a command or macro of Klipper"), name),
                         NC_("core", "what it moves is not known and missing")};
  });
  return true;
}

void IsoReader::run_words(Scanner& scan) {
  const bool readable = statements_.read(scan);
  has_words_ = has_words_ || statements_.has_assigned();
  run_block(statements_.block(), readable);
}

void IsoReader::run_block(const Block& block, bool readable) {
  has_words_ = has_words_ || !block.words.empty();
  report_faults(machining(), block);
  gather(block);
  const bool sound =
      readable && std::all_of(block.faults.begin(), block.faults.end(),
                              [](const Fault& fault) { return fault.kind == FaultKind::unclosed_comment; });
  if (context_.words.macro_call) {
    if (sound) {
      calls_.run_macro_call(block);
    }
    return;
  }
  modal_words_.apply_feed();
  if (sound) {
    run_functions();
    checks_.run();
    if (context_.words.dwell > 0) {
      dwells_.run();
    } else {
      motions_.run();
    }
  }
  if (context_.words.stop) {
    path().pause(Pause::stop);
  }
  calls_.run(sound);
}

std::uint32_t IsoReader::first_word(std::string_view line) {
  const Block& block = lexer_.read(line);
  return block.words.empty() ? block.statement : block.words.front().column;
}

void IsoReader::gather(const Block& block) {
  BlockWords& words = context_.words;
  words.clear();
  bool codes = false;
  for (const Word& word : block.words) {
    if (word.comma) {
      words.corner = &word;
      continue;
    }
    switch (word.letter) {
      case 'G':
        words.macro_call |= word.value == 65 || word.value == 66;
        codes = true;
        continue;
      case 'M':
        codes = true;
        continue;
      case '@':
        words.distance = &word;
        continue;
      case '^':
        words.angle = &word;
        continue;
      case 'N':
      case 'O':
        continue;
      default:
        break;
    }
    if (words.has(word.letter) && !words.macro_call) {
      report(Severity::error, "duplicate-word", 0, word.column, [&] {
        return Text{message(NC_("core", "{} is programmed twice in this block"), word.letter),
                    message(NC_("core", "{} is used; remove the other"), in_quotes(block.text_of(word)))};
      });
    }
    words.set(word);
  }
  if (codes && !words.macro_call) {
    for (const Word& word : block.words) {
      if (word.letter == 'G') {
        modal_words_.apply_g(block, word);
      } else if (word.letter == 'M') {
        modal_words_.apply_m(word);
      }
    }
  }
  modal_words_.apply_tool();
}

void IsoReader::run_functions() {
  const BlockWords& words = context_.words;
  compensation_.select_offset();
  for (std::size_t i = 0; i < words.function_count; ++i) {
    run_function(words.functions[i].code, words.functions[i].column);
  }
  compensation_.follow_block();
}

void IsoReader::run_function(int code, std::uint32_t column) {
  constexpr int first_compensation = 400;
  constexpr int last_compensation = 421;
  switch (code) {
    case 100:
      set_data(column);
      break;
    case 150:
    case 160:
      targets_.set_polar(code == 160);
      break;
    case 280:
    case 281:
    case 290:
    case 300:
    case 301:
    case 530:
      machine_positions_.run(code, column);
      break;
    case 700:
    case 710:
    case 720:
      cycles_.run_pattern(code, column);
      break;
    case 980:
    case 990:
      context_.modal.to_initial_level = code == 980;
      break;
    default:
      if (code >= first_compensation && code <= last_compensation) {
        compensation_.run(code, column);
      } else {
        coordinates_.run(code, column);
      }
      break;
  }
}

/// G10.
void IsoReader::set_data(std::uint32_t column) {
  const int kind =
      context_.words.has('L') ? static_cast<int>(std::clamp(context_.words['L'].value, -1.0, 1e6)) : 1;
  const bool fanuc = context_.dialect == Dialect::fanuc;
  switch (kind) {
    case 1:
    case 10:
    case 11:
    case 12:
    case 13:
      compensation_.set_radius(kind, column);
      break;
    case 2:
      coordinates_.set_work_offset(false, column);
      break;
    case 20:
      fanuc ? coordinates_.set_work_offset(true, column) : coordinates_.preset_work_offset(column);
      break;
    default:
      report(Severity::warning, "unread-g", 100, column, [&] {
        return Text{message(NC_("core", "G10 L{} (data setting) is not supported"), kind),
                    NC_("core", "the path is shown without it")};
      });
      break;
  }
}

bool IsoReader::is_no_block(const Block& block) {
  if (context_.dialect == Dialect::grbl) {
    return is_grbl_command(block);
  }
  const bool is_number = !block.words.empty() && block.words.front().letter == 'O';
  return context_.dialect == Dialect::fanuc && is_number && calls_.ends_at_program_number(has_words_);
}

bool IsoReader::is_grbl_command(const Block& block) {
  constexpr std::string_view commands = "$?!~";
  const bool command = block.words.empty() && !block.faults.empty() &&
                       commands.find(block.text_of(block.faults.front())) != std::string_view::npos;
  if (command) {
    report(Severity::info, "control-command", 0, block.faults.front().column, [&] {
      return Text{message(NC_("core", "{} is a control command"), in_quotes(block.text)),
                  NC_("core", "it does not change the path")};
    });
  }
  return command;
}

}  // namespace feedscope::iso
