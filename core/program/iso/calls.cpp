// The part of IsoReader that calls subprograms and macros, and comes back from them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/program/iso/iso_reader.h"
#include "core/program/text/message.h"

namespace feedscope {

namespace {

constexpr double most_times = 1e9;

/// File names that a program number may have beside the program: O0100, O100, 0100, 100, without an ending
/// and with those in use, the program's own first.
std::vector<std::string> file_names(std::uint32_t number, const std::string& own_ending) {
  std::vector<std::string> names;
  for (const std::string& stem : {fmt::format("O{:04}", number), fmt::format("O{}", number),
                                  fmt::format("{}", number), fmt::format("{:04}", number)}) {
    for (const std::string_view ending :
         {std::string_view(own_ending), std::string_view(), std::string_view(".nc"), std::string_view(".ngc"),
          std::string_view(".cnc"), std::string_view(".tap"), std::string_view(".txt")}) {
      names.push_back(stem + std::string(ending));
    }
  }
  return names;
}

/// Variable of an argument letter, by Fanuc's first way of giving arguments; 0: none. I, J and K may stand
/// several times, the second way.
std::uint32_t variable_of(char letter) {
  constexpr std::string_view letters = "ABCIJKDEF?H?M???QRSTUVWXYZ";
  const std::size_t at = letters.find(letter);
  return at == std::string_view::npos ? 0 : static_cast<std::uint32_t>(at + 1);
}

bool is_program_number(double value) {
  return value >= 0 && value <= 999999999 && value == std::floor(value);
}

}  // namespace

void IsoReader::run_calls(bool sound) {
  if (words_.flow != nullptr) {
    const Word& word = *words_.flow;
    if (word.value == 99) {
      return_to(word);
    } else if (sound) {
      word.value == 97 ? call_blocks(word) : call_subprogram(word);
    }
    return;
  }
  const bool moved =
      sound && (words_.has_any("XYZ") || words_.has_polar()) && !words_.own_words && words_.dwell == 0;
  if (modal_macro_ && moved && call_depth() == modal_macro_->depth) {
    call_macro(*modal_macro_);
  }
}

void IsoReader::call_subprogram(const Word& word) {
  if (!words_.has('P')) {
    call_named_file(word);
    return;
  }
  const Word& program = words_['P'];
  double number = program.value;
  double times = repeats_of_block();
  Subprogram found = find_program(number);
  if (found.text == nullptr && number >= 10000 && !words_.has('L')) {
    // P030100: program 100, three times.
    times = std::floor(number / 10000);
    number = std::fmod(number, 10000);
    found = find_program(number);
  }
  if (found.text == nullptr) {
    report_missing(fmt::format("M{} calls program {:.0f}", word.value, number),
                   fmt::format("O{:04.0f}", number), program.column);
    return;
  }
  enter(found, times, std::nullopt);
}

void IsoReader::call_named_file(const Word& word) {
  // The name stands in brackets, which to the lexer are a comment.
  const std::string_view line = text().line(this->line());
  const std::size_t from = line.find('(', word.column);
  const std::size_t to = line.find(')', from == std::string_view::npos ? 0 : from);
  if (from == std::string_view::npos || to == std::string_view::npos) {
    report(Severity::error, "subprogram", 1, word.column, [&] {
      return Text{fmt::format("M{} without P", word.value),
                  "nothing is called; write P with the number of the subprogram"};
    });
    return;
  }
  const std::string name = std::filesystem::path(line.substr(from + 1, to - from - 1)).filename().string();
  const std::shared_ptr<const SourceText> file = subprogram_files().find({name, name + ".nc"});
  if (file == nullptr) {
    report_missing(fmt::format("M{} calls file {}", word.value, quoted(std::string_view(name))), name,
                   static_cast<std::uint32_t>(from + 1));
    return;
  }
  enter({file, 1}, repeats_of_block(), std::nullopt);
}

void IsoReader::call_blocks(const Word& word) {
  const std::uint32_t target =
      words_.has('P') && is_program_number(words_['P'].value)
          ? flow_index(text()).block(static_cast<std::uint32_t>(words_['P'].value), line() + 1)
          : 0;
  if (target == 0) {
    throw ReadFault{"jump-target", word.column, "M97 has no P with the number of a block in this program",
                    "nothing is called; write P with the N number of the first block"};
  }
  enter({text_in_force(), target}, repeats_of_block(), std::nullopt);
}

void IsoReader::return_to(const Word& word) {
  const bool called = call_depth() > 0;
  std::uint32_t from = line() + 1;
  if (called) {
    from = frames_.back().called_from;
    const std::size_t depth = call_depth();
    leave_call();
    if (call_depth() == depth) {
      return;
    }
  }
  if (!words_.has('P')) {
    if (!called) {
      end_program();
    }
    return;
  }
  const double number = words_['P'].value;
  const std::uint32_t block =
      is_program_number(number) ? flow_index(text()).block(static_cast<std::uint32_t>(number), from) : 0;
  if (block == 0) {
    throw ReadFault{"jump-target", word.column, fmt::format("there is no block N{} to go to", number),
                    "the jump is left out; correct the number"};
  }
  if (!called && block <= line()) {
    report(Severity::info, "endless-program", 0, word.column, [&] {
      return Text{fmt::format("the program starts over from N{} without end", number), "one pass is shown"};
    });
    end_program();
    return;
  }
  jump_to(block);
}

double IsoReader::repeats_of_block() {
  if (!words_.has('L')) {
    return 1;
  }
  const Word& word = words_['L'];
  if (word.value >= 0 && word.value <= most_times && word.value == std::floor(word.value)) {
    return word.value;
  }
  report(Severity::error, "repeat-count", 0, word.column, [&] {
    return Text{fmt::format("L{} is not a number of times from 0 to {}", word.value, most_times),
                "it is run once"};
  });
  return 1;
}

void IsoReader::report_missing(const std::string& who, const std::string& file, std::uint32_t column) {
  report(Severity::error, "subprogram", 0, column, [&] {
    return Text{fmt::format("{}, which is neither in the program nor a file in its folder", who),
                fmt::format("its motion is missing; put it into the program's folder as {}", file)};
  });
}

void IsoReader::gather_macro_call(const Block& block) {
  MacroCall macro;
  macro.arguments = variables_.no_arguments();
  std::uint32_t last_center = 3;  // of I, J and K, whose further groups are #7 to #9 and so on
  double kind = 0;
  for (const Word& word : block.words) {
    switch (word.letter) {
      case 'G':
        kind = word.value == 65 || word.value == 66 ? word.value : kind;
        break;
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
  macro.depth = call_depth();
  macro.found = find_program(macro.program);
  if (macro.column == 0) {
    report(Severity::error, "subprogram", 1, block.words.front().column, [&] {
      return Text{fmt::format("G{} without P", kind), "nothing is called; write P with the macro's number"};
    });
  } else if (macro.found.text == nullptr) {
    modal_macro_.reset();
    report_missing(fmt::format("macro program {:.0f} is called", macro.program),
                   fmt::format("O{:04.0f}", macro.program), macro.column);
  } else if (kind == 66) {
    modal_macro_ = macro;
  } else {
    call_macro(macro);
  }
}

void IsoReader::call_macro(const MacroCall& macro) {
  enter(macro.found, macro.times, macro.arguments);
}

void IsoReader::call_o_word(const std::string& label, std::uint32_t column, Scanner& scan) {
  constexpr std::uint32_t most_arguments = 30;
  IsoVariables::Locals arguments = variables_.no_arguments();
  for (std::uint32_t i = 1; !scan.at_end(); ++i) {
    const std::uint32_t argument_column = scan.column();
    const double value = expression_.read_operand(scan);
    if (i > most_arguments) {
      throw ReadFault{"expression", argument_column, "a call has more than 30 arguments",
                      "the call is left out; pass the rest in global variables"};
    }
    arguments[i] = value;
  }
  const Subprogram found = find_o_word(label);
  if (found.text == nullptr) {
    const bool named = label.front() == '<';
    report_missing(fmt::format("o{} is called", label),
                   (named ? label.substr(1, label.size() - 2) : label) + ".ngc", column);
    return;
  }
  enter(found, 1, arguments);
}

void IsoReader::return_from_o_word(Scanner& scan) {
  const std::optional<double> value =
      scan.at_end() ? std::nullopt : std::optional(expression_.read_operand(scan));
  if (call_depth() == 0) {
    throw ReadFault{"flow-pair", scan.column(), "a return outside of a subprogram",
                    "it is left out; subprograms stand between sub and endsub"};
  }
  report_rest(scan);
  leave_call();
  variables_.set("_value", value.value_or(0));
  variables_.set("_value_returned", value ? 1 : 0);
}

void IsoReader::enter(const Subprogram& subprogram, double times,
                      const std::optional<IsoVariables::Locals>& arguments) {
  if (times < 1) {
    return;
  }
  const std::uint32_t called_from = line();
  if (!call(subprogram.text, subprogram.line, static_cast<std::uint32_t>(times))) {
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

void IsoReader::leave_call() {
  const std::size_t depth = call_depth();
  return_from_call();
  Frame& frame = frames_.back();
  if (call_depth() == depth) {
    // The call runs again, from new.
    frame.repeats.clear();
    if (frame.arguments) {
      variables_.leave();
      variables_.enter(*frame.arguments);
    }
  }
}

void IsoReader::left_call() {
  const Frame& frame = frames_.back();
  if (frame.arguments) {
    variables_.leave();
  }
  if (frame.kept && frame.kept->until_return) {
    restore(*frame.kept);
  }
  if (modal_macro_ && modal_macro_->depth > call_depth()) {
    modal_macro_.reset();
  }
  frames_.pop_back();
}

IsoReader::Subprogram IsoReader::find_program(double number) {
  if (!is_program_number(number)) {
    return {};
  }
  const auto program = static_cast<std::uint32_t>(number);
  const std::string label = std::to_string(program);
  for (const std::shared_ptr<const SourceText>& candidate : {text_in_force(), main_text()}) {
    const FlowIndex& index = flow_index(*candidate);
    if (const std::uint32_t line = index.program(program); line > 0) {
      return {candidate, line};
    }
    if (const std::uint32_t line = index.sub(label); line > 0) {
      return {candidate, line + 1};
    }
  }
  const auto [known, is_new] = program_files_.try_emplace(program);
  if (is_new) {
    const std::string ending = std::filesystem::path(main_text()->name()).extension().string();
    known->second = subprogram_files().find(file_names(program, ending));
  }
  if (known->second == nullptr) {
    return {};
  }
  const std::uint32_t line = flow_index(*known->second).program(program);
  return {known->second, std::max(line, 1U)};
}

IsoReader::Subprogram IsoReader::find_o_word(const std::string& label) {
  for (const std::shared_ptr<const SourceText>& candidate : {text_in_force(), main_text()}) {
    if (const std::uint32_t line = flow_index(*candidate).sub(label); line > 0) {
      return {candidate, line + 1};
    }
  }
  const std::string name = label.front() == '<' ? label.substr(1, label.size() - 2) : label;
  const std::shared_ptr<const SourceText> file = subprogram_files().find({name + ".ngc", name + ".nc"});
  const std::uint32_t line = file == nullptr ? 0 : flow_index(*file).sub(label);
  return line > 0 ? Subprogram{file, line + 1} : Subprogram{};
}

}  // namespace feedscope
