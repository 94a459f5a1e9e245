#include "core/program/iso/language/calls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::iso {

namespace {

constexpr double max_times = 1e9;

/// Variable of an argument letter in Fanuc's first form of arguments; 0: none. I, J and K may occur several
/// times in the second form.
std::uint32_t variable_of(char letter) {
  constexpr std::string_view letters = "ABCIJKDEF?H?M???QRSTUVWXYZ";
  const std::size_t at = letters.find(letter);
  return at == std::string_view::npos ? 0 : static_cast<std::uint32_t>(at + 1);
}

}  // namespace

void Calls::run(bool sound) {
  if (words_.flow != nullptr) {
    const Word& word = *words_.flow;
    if (word.value == 99) {
      return_to(word);
    } else if (sound) {
      word.value == 97 ? call_blocks(word) : call_program(word);
    }
    return;
  }
  const bool moved =
      sound && (words_.has_any("XYZ") || words_.has_polar()) && !words_.own_words && words_.dwell == 0;
  if (modal_macro_ && moved && lines().call_depth() == modal_macro_->depth) {
    call(*modal_macro_);
  }
}

void Calls::call_program(const Word& word) {
  if (!words_.has('P')) {
    call_named_file(word);
    return;
  }
  const Word& program = words_['P'];
  double number = program.value;
  double times = repeats_of_block();
  Subprogram found = subprograms_.program(number);
  if (found.text == nullptr && number >= 10000 && !words_.has('L')) {
    // P030100: program 100, three times.
    times = std::floor(number / 10000);
    number = std::fmod(number, 10000);
    found = subprograms_.program(number);
  }
  if (found.text == nullptr) {
    report_missing(
        message(NC_("core",
                    "M{} calls program {:.0f}, which is neither in the program nor in a file in its folder"),
                word.value, number),
        fmt::format("O{:04.0f}", number), program.column);
    return;
  }
  enter(found, times, std::nullopt);
}

void Calls::call_named_file(const Word& word) {
  // The name is in brackets, which the lexer reads as a comment.
  const std::string_view line = lines().text().line(lines().line());
  const std::size_t from = line.find('(', word.column);
  const std::size_t to = line.find(')', from == std::string_view::npos ? 0 : from);
  if (from == std::string_view::npos || to == std::string_view::npos) {
    report(Severity::error, "subprogram", 1, word.column, [&] {
      return Text{message(NC_("core", "M{} without P"), word.value),
                  NC_("core", "nothing is called; write P with the number of the subprogram")};
    });
    return;
  }
  const std::string name = std::filesystem::path(line.substr(from + 1, to - from - 1)).filename().string();
  const Subprogram found = subprograms_.file(name);
  if (found.text == nullptr) {
    report_missing(
        message(NC_("core", "M{} calls file {}, which is neither in the program nor in a file in its folder"),
                word.value, in_quotes(std::string_view(name))),
        name, static_cast<std::uint32_t>(from + 1));
    return;
  }
  enter(found, repeats_of_block(), std::nullopt);
}

void Calls::call_blocks(const Word& word) {
  const std::uint32_t target =
      words_.has('P') && is_program_number(words_['P'].value)
          ? indexes_.of(lines().text())
                .block(static_cast<std::uint32_t>(words_['P'].value), lines().line() + 1)
          : 0;
  if (target == 0) {
    throw ReadFault{"jump-target", word.column,
                    NC_("core", "M97 without P and the number of a block in this program"),
                    NC_("core", "nothing is called; write P with the N number of the first block")};
  }
  enter({lines().text_in_force(), target}, repeats_of_block(), std::nullopt);
}

void Calls::return_to(const Word& word) {
  const bool called = lines().call_depth() > 0;
  std::uint32_t from = lines().line() + 1;
  if (called) {
    from = frames_.back().called_from;
    const std::size_t depth = lines().call_depth();
    leave();
    if (lines().call_depth() == depth) {
      return;
    }
  }
  if (!words_.has('P')) {
    if (!called) {
      lines().end_program();
    }
    return;
  }
  const double number = words_['P'].value;
  const std::uint32_t block =
      is_program_number(number) ? indexes_.of(lines().text()).block(static_cast<std::uint32_t>(number), from)
                                : 0;
  if (block == 0) {
    throw ReadFault{"jump-target", word.column,
                    message(NC_("core", "jump target N{} does not exist"), number),
                    NC_("core", "the jump is skipped; correct the number")};
  }
  if (!called && block <= lines().line()) {
    report(Severity::info, "endless-program", 0, word.column, [&] {
      return Text{message(NC_("core", "the program repeats from N{} without end"), number),
                  NC_("core", "one pass is shown")};
    });
    lines().end_program();
    return;
  }
  lines().jump_to(block);
}

double Calls::repeats_of_block() const {
  if (!words_.has('L')) {
    return 1;
  }
  const Word& word = words_['L'];
  if (word.value >= 0 && word.value <= max_times && word.value == std::floor(word.value)) {
    return word.value;
  }
  report(Severity::error, "repeat-count", 0, word.column, [&] {
    return Text{message(NC_("core", "L{} is not a number of times from 0 to {}"), word.value, max_times),
                NC_("core", "it is run once")};
  });
  return 1;
}

void Calls::report_missing(const Message& what, const std::string& file, std::uint32_t column) const {
  report(Severity::error, "subprogram", 0, column, [&] {
    return Text{
        what,
        message(NC_("core", "its motion is missing; add the file \"{}\" to the program's folder"), file)};
  });
}

Calls::MacroCall Calls::macro_call(const Block& block) const {
  MacroCall macro;
  macro.arguments = variables_.no_arguments();
  std::uint32_t last_center = 3;  // of I, J and K, whose further groups are #7 to #9 and so on
  for (const Word& word : block.words) {
    switch (word.letter) {
      case 'P':
        macro.program = word.value;
        macro.column = word.column;
        break;
      case 'I':
      case 'J':
      case 'K': {
        std::uint32_t variable = variable_of(word.letter);
        while (variable <= last_center) {
          variable += 3;
        }
        if (variable < macro.arguments.size()) {
          macro.arguments[variable] = word.value;
          last_center = variable;
        }
        break;
      }
      default:
        if (const std::uint32_t variable = variable_of(word.letter); variable > 0) {
          macro.arguments[variable] = word.value;
        }
        break;
    }
  }
  macro.times = repeats_of_block();
  macro.depth = lines().call_depth();
  macro.found = subprograms_.program(macro.program);
  return macro;
}

void Calls::run_macro_call(const Block& block) {
  double kind = 0;
  for (const Word& word : block.words) {
    if (word.letter == 'G' && (word.value == 65 || word.value == 66)) {
      kind = word.value;
    }
  }
  const MacroCall macro = macro_call(block);
  if (macro.column == 0) {
    report(Severity::error, "subprogram", 1, block.words.front().column, [&] {
      return Text{message(NC_("core", "G{} without P"), kind),
                  NC_("core", "nothing is called; write P with the macro's number")};
    });
  } else if (macro.found.text == nullptr) {
    modal_macro_.reset();
    report_missing(message(NC_("core",
                               "macro program {:.0f} is called, which is neither in the program nor in a "
                               "file in its folder"),
                           macro.program),
                   fmt::format("O{:04.0f}", macro.program), macro.column);
  } else if (kind == 66) {
    modal_macro_ = macro;
  } else {
    call(macro);
  }
}

void Calls::call_sub(const std::string& label, std::uint32_t column, const std::vector<double>& arguments) {
  const Subprogram found = subprograms_.sub(label);
  if (found.text == nullptr) {
    const bool named = label.front() == '<';
    report_missing(
        message(NC_("core", "o{} is called, which is neither in the program nor in a file in its folder"),
                label),
        (named ? label.substr(1, label.size() - 2) : label) + ".ngc", column);
    return;
  }
  Variables::Locals locals = variables_.no_arguments();
  std::copy(arguments.begin(), arguments.end(), locals.begin() + 1);
  enter(found, 1, locals);
}

void Calls::enter(const Subprogram& subprogram, double times,
                  const std::optional<Variables::Locals>& arguments) {
  if (times < 1) {
    return;
  }
  const std::uint32_t called_from = lines().line();
  if (!lines().call(subprogram.text, subprogram.line, static_cast<std::uint32_t>(times))) {
    return;
  }
  Frame frame;
  frame.called_from = called_from;
  frame.arguments = arguments;
  frames_.push_back(std::move(frame));
  if (arguments) {
    variables_.enter(*arguments);
  }
}

void Calls::leave() {
  switch (lines().return_from_call()) {
    case LineRunner::Returned::no_call:
      break;
    case LineRunner::Returned::again: {
      Frame& frame = frames_.back();
      frame.repeats.clear();
      if (frame.arguments) {
        variables_.leave();
        variables_.enter(*frame.arguments);
      }
      break;
    }
    case LineRunner::Returned::left:
      if (frames_.back().arguments) {
        variables_.leave();
      }
      kept_modes_.leave_call();
      if (modal_macro_ && modal_macro_->depth > lines().call_depth()) {
        modal_macro_.reset();
      }
      frames_.pop_back();
      break;
  }
}

bool Calls::ends_at_program_number(bool begun) {
  std::uint32_t& start = frames_.back().program;
  const bool in_call = lines().call_depth() > 0;
  if (start == lines().line() || (start == 0 && (in_call || !begun))) {
    start = lines().line();
    return false;
  }
  if (in_call) {
    leave();
  } else {
    lines().end_program();
  }
  return true;
}

}  // namespace feedscope::iso
