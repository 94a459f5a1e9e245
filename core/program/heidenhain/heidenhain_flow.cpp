// The part of HeidenhainCore for labels, calls and the program's end.
#include <fmt/format.h>

#include <cmath>

#include "core/program/heidenhain/heidenhain_core.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

std::string HeidenhainCore::label(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  if (scanner.take('"')) {
    const std::string_view rest = scanner.text().substr(scanner.at());
    const std::size_t end = rest.find('"');
    if (end == std::string_view::npos || end == 0) {
      throw ReadFault{"label", column, "the name of the label is not closed, or empty",
                      "write it as \"NAME\""};
    }
    scanner.move_to(scanner.at() + end + 1);
    return fmt::format("\"{}\"", rest.substr(0, end));
  }
  const std::size_t before = scanner.at();
  if (const auto name = take_parameter(scanner); name && name->kind == QName::Kind::text) {
    return fmt::format("\"{}\"", parameters_.text(name->number));
  }
  scanner.move_to(before);
  const double number = formulas_.read_value(scanner);
  if (!(number >= 0) || number != std::floor(number) || number > 65535) {
    throw ReadFault{"label", column, fmt::format("{} is no label", number),
                    "write a whole number from 1 to 65535 or a name in quotes"};
  }
  return fmt::format("{}", number);
}

const HeidenhainCore::Labels& HeidenhainCore::labels() {
  const auto [found, is_new] = labels_.try_emplace(&text());
  if (is_new) {
    for (std::uint32_t line = 1; line <= text().line_count(); ++line) {
      try {
        const std::string label = label_on(text().line(line));
        if (!label.empty() && !found->second.try_emplace(label, line).second) {
          log().add(Severity::warning, "label", 1, {line, 0, place(0).file}, [&] {
            return Text{fmt::format("label {} is set again", label),
                        "the first one counts; a control refuses such a program"};
          });
        }
      } catch (const ReadFault&) {
        // Said when the line itself runs.
      }
    }
  }
  return found->second;
}

std::optional<std::uint32_t> HeidenhainCore::line_of_label(const std::string& label, std::uint32_t column) {
  const Labels& known = labels();
  const auto found = known.find(label);
  if (found != known.end()) {
    return found->second;
  }
  report(Severity::error, "label-missing", 0, column, [&] {
    return Text{fmt::format("label {} does not exist", label), "the jump or call is left out"};
  });
  return std::nullopt;
}

bool HeidenhainCore::enter(const std::shared_ptr<const SourceText>& called, std::uint32_t line,
                           bool program) {
  if (!(called != nullptr ? call(called, line) : call(line))) {
    return false;
  }
  Frame& frame = frames_.emplace_back();
  frame.program = program;
  frame.unit = unit_;
  if (program) {
    frame.locals = parameters_.exchange_locals({});
  }
  return true;
}

void HeidenhainCore::left_call() {
  Frame& frame = frames_.back();
  if (frame.program) {
    unit_ = frame.unit;
    parameters_.exchange_locals(std::move(frame.locals));
  }
  frames_.pop_back();
}

void HeidenhainCore::call_label(const std::string& label, std::uint32_t column) {
  if (const auto line = line_of_label(label, column)) {
    enter(nullptr, *line, false);
  }
}

void HeidenhainCore::repeat_from_label(const std::string& label, double times, std::uint32_t column) {
  const auto line = line_of_label(label, column);
  if (!line) {
    return;
  }
  const auto [left, is_new] = repeats_left_.try_emplace({call_depth(), &text(), this->line()}, times);
  if (left->second >= 1) {
    --left->second;
    jump_to(*line);
  } else {
    repeats_left_.erase(left);
  }
}

void HeidenhainCore::jump_to_label(const std::string& label, std::uint32_t column) {
  if (const auto line = line_of_label(label, column)) {
    jump_to(*line);
  }
}

void HeidenhainCore::end_subprogram() {
  if (!frames_.empty() && !frames_.back().program) {
    return_from_call();
  }
}

void HeidenhainCore::end_of_program() {
  while (!frames_.empty()) {
    const bool program = frames_.back().program;
    return_from_call();
    if (program) {
      return;
    }
  }
  end_program();
}

void HeidenhainCore::call_program(std::string_view written, std::uint32_t column) {
  Scanner scanner(written);
  const auto parameter = take_parameter(scanner);
  std::string_view name =
      parameter && parameter->kind == QName::Kind::text ? parameters_.text(parameter->number) : written;
  while (!name.empty() && (letters::is_blank(name.front()) || name.front() == '"')) {
    name.remove_prefix(1);
  }
  while (!name.empty() && (letters::is_blank(name.back()) || name.back() == '"')) {
    name.remove_suffix(1);
  }
  if (const std::size_t folder = name.find_last_of("\\/:"); folder != std::string_view::npos) {
    name.remove_prefix(folder + 1);
  }
  const std::string file(name);
  const auto called = name.empty() ? nullptr : subprogram_files().find({file, file + ".h", file + ".i"});
  if (called == nullptr) {
    report(Severity::error, "subprogram", 0, column, [&] {
      return Text{fmt::format("the program {} does not lie beside this one", quoted(name)),
                  "its motion is left out; put the file into the same folder"};
    });
    return;
  }
  const Dialect found = recognise(*called);
  if (found != Dialect::iso && found != dialect()) {
    report(Severity::error, "subprogram", 1, column, [&] {
      return Text{
          fmt::format("the program {} is written in another dialect, {}", quoted(name), info_of(found).title),
          "its motion is left out"};
    });
    return;
  }
  enter(called, 1, true);
}

}  // namespace feedscope
