#include "core/program/sinumerik/language/repeats.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

bool Repeats::run(std::string_view name, Scanner& scanner) {
  if (letters::same(name, "REPEAT") && !scanner.at_end()) {
    run_part(scanner);
  } else if (letters::same(name, "REPEATB")) {
    run_line(scanner);
  } else {
    return false;
  }
  return true;
}

/// "REPEAT BEGIN END P=2", "REPEAT BEGIN P=2".
void Repeats::run_part(Scanner& scanner) {
  const ProgramIndex& index = indexes_.of(lines().text());
  const std::uint32_t line = lines().line();
  const std::uint32_t column = scanner.column();
  const std::uint32_t begin = label_line(scanner, column);
  std::uint32_t end = begin < line ? line - 1 : index.forward("ENDLABEL", begin);
  Scanner behind = scanner;
  const bool counted = behind.take('P') && (behind.peek() == '=' || letters::is_digit(behind.peek()));
  if (!counted && !scanner.at_end()) {
    end = label_line(scanner, column);
  } else if (const std::uint32_t marked = index.forward("ENDLABEL", begin); marked > 0 && marked < line) {
    end = marked;
  }
  if (end < begin) {
    throw ReadFault{"unknown-label", column,
                    NC_("core", "the part to be repeated does not end after its beginning"),
                    NC_("core", "nothing is repeated; write a second label or ENDLABEL")};
  }
  add(begin, end, scanner);
}

/// "REPEATB LABEL P=2": the block with the label.
void Repeats::run_line(Scanner& scanner) {
  const std::uint32_t begin = label_line(scanner, scanner.column());
  add(begin, begin, scanner);
}

/// Line of the next label; `column` for messages.
std::uint32_t Repeats::label_line(Scanner& scanner, std::uint32_t column) {
  const ProgramIndex& index = indexes_.of(lines().text());
  const std::string label = jumps_.label(scanner);
  const std::uint32_t line = lines().line();
  const std::uint32_t before = index.backward(label, line);
  const std::uint32_t found = before > 0 ? before : index.forward(label, line);
  if (found == 0 || found == line) {
    throw ReadFault{
        "unknown-label", column,
        message(NC_("core", "label {} does not exist in the program"), feedscope::in_quotes(label)),
        NC_("core", "nothing is repeated; check the label")};
  }
  return found;
}

std::uint32_t Repeats::count(Scanner& scanner) {
  constexpr double max_runs = 1e6;
  if (!scanner.take('P')) {
    return 1;
  }
  scanner.take('=');
  return static_cast<std::uint32_t>(std::clamp(std::floor(values_.read(scanner) + 0.5), 0.0, max_runs));
}

void Repeats::add(std::uint32_t begin, std::uint32_t end, Scanner& scanner) {
  const std::uint32_t runs = count(scanner);
  if (runs == 0) {
    return;
  }
  splines_.finish();
  repeats_.push_back({.begin = begin,
                      .end = end,
                      .resume = lines().line() + 1,
                      .left = runs,
                      .depth = lines().call_depth()});
  lines().jump_to(begin);
}

bool Repeats::is_over(std::uint32_t next) {
  if (repeats_.empty() || repeats_.back().depth != lines().call_depth() || next != repeats_.back().end + 1) {
    return false;
  }
  Repeat& repeat = repeats_.back();
  if (--repeat.left > 0) {
    lines().jump_to(repeat.begin);
  } else {
    lines().jump_to(repeat.resume);
    repeats_.pop_back();
  }
  return true;
}

void Repeats::leave_call() {
  std::erase_if(repeats_, [this](const Repeat& repeat) { return repeat.depth > lines().call_depth(); });
}

}  // namespace feedscope::sinumerik
