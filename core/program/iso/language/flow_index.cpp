#include "core/program/iso/language/flow_index.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/program/iso/language/expression.h"
#include "core/program/text/lexer.h"

namespace feedscope::iso {

namespace {

struct NamedWord {
  std::string_view name;
  FlowWord word;
};

constexpr auto o_words = std::to_array<NamedWord>({
    {"SUB", FlowWord::sub},
    {"ENDSUB", FlowWord::endsub},
    {"CALL", FlowWord::call},
    {"IF", FlowWord::if_},
    {"ELSEIF", FlowWord::elseif},
    {"ELSE", FlowWord::else_},
    {"ENDIF", FlowWord::endif},
    {"DO", FlowWord::do_},
    {"WHILE", FlowWord::while_},
    {"ENDWHILE", FlowWord::endwhile},
    {"REPEAT", FlowWord::repeat},
    {"ENDREPEAT", FlowWord::endrepeat},
    {"BREAK", FlowWord::break_},
    {"CONTINUE", FlowWord::continue_},
    {"RETURN", FlowWord::return_},
});

/// Reads digits, without leading zeros; empty for none or for a number of more than nine.
std::string take_digits(Scanner& scan) {
  scan.peek();
  const std::size_t from = scan.at();
  std::size_t to = from;
  while (to < scan.text().size() && letters::is_digit(scan.text()[to])) {
    ++to;
  }
  std::string_view digits = scan.text().substr(from, to - from);
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.empty() ? 0 : digits.size() - 1));
  if (digits.empty() || digits.size() > 9) {
    return {};
  }
  scan.move_to(to);
  return std::string(digits);
}

std::optional<std::uint32_t> take_number(Scanner& scan) {
  const std::string digits = take_digits(scan);
  return digits.empty() ? std::nullopt : std::optional(static_cast<std::uint32_t>(std::stoul(digits)));
}

/// Moves after comments "(...)".
void skip_comments(Scanner& scan) {
  CommentEnds ends;
  while (scan.peek() == '(') {
    const std::optional<std::size_t> end = ends.find(scan.text(), scan.at());
    scan.move_to(end.value_or(scan.text().size()));
  }
}

/// Number of the last "DO" of a line that begins with WHILE; empty if it has none.
std::string loop_of_while(std::string_view text) {
  text = text.substr(0, text.find_first_of("(;"));
  for (std::size_t at = text.size(); at-- > 1;) {
    Scanner scan(text, at);
    if (!letters::is_letter(text[at - 1]) && letters::is_letter(text[at]) && scan.take_keyword("DO")) {
      return take_digits(scan);
    }
  }
  return {};
}

/// True if an IF over many lines ends in THEN, with no statement after it.
bool ends_in_then(std::string_view text) {
  text = text.substr(0, text.find_first_of("(;"));
  text = text.substr(0, text.find_last_not_of(" \t") + 1);
  constexpr std::string_view then = "THEN";
  return text.size() > then.size() && letters::same(text.substr(text.size() - then.size()), then);
}

}  // namespace

bool take_macro_word(Scanner& scan, std::string_view word) {
  scan.peek();
  std::size_t length = 0;
  while (letters::is_letter(scan.peek_at(length))) {
    ++length;
  }
  constexpr std::size_t least = 2;
  const bool fits = length >= least && length <= word.size() && scan.peek_at(length) != '_' &&
                    letters::same(scan.text().substr(scan.at(), length), word.substr(0, length));
  if (fits) {
    scan.move_to(scan.at() + length);
  }
  return fits;
}

FlowWord o_word_named(std::string_view name) {
  const auto found = std::find_if(o_words.begin(), o_words.end(), [&](const NamedWord& candidate) {
    return letters::same(candidate.name, name);
  });
  return found == o_words.end() ? FlowWord::none : found->word;
}

std::string take_o_label(Scanner& scanner) {
  if (scanner.peek() != '<') {
    return take_digits(scanner);
  }
  const std::size_t end = scanner.text().find('>', scanner.at());
  if (end == std::string_view::npos) {
    return {};
  }
  const std::string name = normal_name(scanner.text().substr(scanner.at(), end + 1 - scanner.at()));
  scanner.move_to(end + 1);
  return name;
}

FlowIndex::FlowIndex(const SourceText& text, bool skip_deleted) {
  for (std::uint32_t line = 1; line <= text.line_count(); ++line) {
    Scanner scan(text.line(line));
    skip_comments(scan);
    if (scan.take('/')) {
      if (skip_deleted) {
        continue;
      }
      const std::size_t level = scan.at();
      if (letters::is_digit(scan.peek_at(0))) {
        scan.move_to(level + 1);
      }
    }
    read_line(scan, line);
  }
  std::sort(numbers_.begin(), numbers_.end());
  open_.clear();
}

void FlowIndex::read_line(Scanner scan, std::uint32_t line) {
  if (scan.take('N')) {
    if (const std::optional<std::uint32_t> number = take_number(scan)) {
      numbers_.emplace_back(*number, line);
      skip_comments(scan);
    } else {
      scan.move_to(scan.at() - 1);
    }
  }
  switch (letters::to_upper(scan.peek())) {
    case 'O':
    case ':':
      scan.move_to(scan.at() + 1);
      read_o_word(scan, line);
      break;
    case 'W':
      if (take_macro_word(scan, "WHILE")) {
        add(FlowWord::macro_do, loop_of_while(scan.rest()), line);
      }
      break;
    case 'I':
      if (scan.take_keyword("IF") && ends_in_then(scan.rest())) {
        add(FlowWord::if_, "", line);
      }
      break;
    case 'D':
      if (scan.take_keyword("DO")) {
        add(FlowWord::macro_do, take_digits(scan), line);
      }
      break;
    case 'E':
      if (scan.take_keyword("ELSEIF")) {
        add(FlowWord::elseif, "", line);
      } else if (scan.take_keyword("ELSE")) {
        add(FlowWord::else_, "", line);
      } else if (scan.take_keyword("ENDIF")) {
        add(FlowWord::endif, "", line);
      } else if (take_macro_word(scan, "END")) {
        add(FlowWord::macro_end, take_digits(scan), line);
      }
      break;
    default:
      break;
  }
}

void FlowIndex::read_o_word(Scanner& scan, std::uint32_t line) {
  const std::string label = take_o_label(scan);
  if (label.empty()) {
    return;
  }
  const FlowWord word = o_word_named(scan.name());
  if (word != FlowWord::none) {
    add(word, label, line);
  } else if (label.front() != '<') {
    programs_.try_emplace(static_cast<std::uint32_t>(std::stoul(label)), line);
    program_lines_.push_back(line);
  }
}

void FlowIndex::add(FlowWord word, const std::string& label, std::uint32_t line) {
  const Statement statement{line, word, 0, 0, 0};
  const auto key = [&](char kind) { return kind + label; };
  switch (word) {
    case FlowWord::sub:
      subs_.try_emplace(label, line);
      open(statement, key('S'));
      break;
    case FlowWord::endsub:
      close(statement, key('S'));
      break;
    case FlowWord::if_:
      open(statement, key('I'));
      break;
    case FlowWord::elseif:
    case FlowWord::else_:
      branch(statement, key('I'));
      break;
    case FlowWord::endif:
      close(statement, key('I'));
      break;
    case FlowWord::do_:
    case FlowWord::repeat:
      open(statement, key('L'));
      break;
    case FlowWord::while_: {
      const std::vector<Opened>& loops = open_[key('L')];
      if (!loops.empty() && statements_[loops.back().first].word == FlowWord::do_) {
        close(statement, key('L'));
      } else {
        open(statement, key('L'));
      }
      break;
    }
    case FlowWord::endwhile:
    case FlowWord::endrepeat:
      close(statement, key('L'));
      break;
    case FlowWord::break_:
    case FlowWord::continue_:
      leave_loop(statement, key('L'));
      break;
    case FlowWord::macro_do:
      open(statement, key('D'));
      break;
    case FlowWord::macro_end:
      close(statement, key('D'));
      break;
    case FlowWord::call:
    case FlowWord::return_:
    case FlowWord::none:
      break;
  }
}

void FlowIndex::open(const Statement& statement, const std::string& key) {
  open_[key].push_back({statements_.size(), statements_.size()});
  statements_.push_back(statement);
}

void FlowIndex::branch(Statement statement, const std::string& key) {
  if (std::vector<Opened>& opened = open_[key]; !opened.empty()) {
    statement.begin = statements_[opened.back().first].line;
    statements_[opened.back().last].next = statement.line;
    opened.back().last = statements_.size();
  }
  statements_.push_back(statement);
}

void FlowIndex::close(Statement statement, const std::string& key) {
  if (std::vector<Opened>& opened = open_[key]; !opened.empty()) {
    statement.begin = statements_[opened.back().first].line;
    statements_[opened.back().first].end = statement.line;
    statements_[opened.back().last].next = statement.line;
    opened.pop_back();
  }
  statements_.push_back(statement);
}

void FlowIndex::leave_loop(Statement statement, const std::string& key) {
  if (const std::vector<Opened>& opened = open_[key]; !opened.empty()) {
    statement.begin = statements_[opened.back().first].line;
  }
  statements_.push_back(statement);
}

const FlowIndex::Statement* FlowIndex::at(std::uint32_t line) const {
  const auto found = std::lower_bound(
      statements_.begin(), statements_.end(), line,
      [](const Statement& statement, std::uint32_t wanted) { return statement.line < wanted; });
  return found == statements_.end() || found->line != line ? nullptr : &*found;
}

std::vector<std::uint32_t> FlowIndex::subs_within(const Statement& statement) const {
  std::vector<std::uint32_t> lines;
  for (const Statement* inner = &statement + 1;
       inner != statements_.data() + statements_.size() && inner->line < statement.end; ++inner) {
    if (inner->word == FlowWord::sub) {
      lines.push_back(inner->line);
    }
  }
  return lines;
}

std::uint32_t FlowIndex::sub(const std::string& label) const {
  const auto found = subs_.find(label);
  return found == subs_.end() ? 0 : found->second;
}

std::uint32_t FlowIndex::program(std::uint32_t number) const {
  const auto found = programs_.find(number);
  return found == programs_.end() ? 0 : found->second;
}

std::uint32_t FlowIndex::block(std::uint32_t number, std::uint32_t line) const {
  const auto after = std::upper_bound(program_lines_.begin(), program_lines_.end(), line);
  const std::uint32_t start = after == program_lines_.begin() ? 1 : *std::prev(after);
  const std::uint32_t end =
      after == program_lines_.end() ? std::numeric_limits<std::uint32_t>::max() : *after;
  for (const std::uint32_t from : {line, start}) {
    const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), std::pair(number, from));
    if (found != numbers_.end() && found->first == number && found->second < end) {
      return found->second;
    }
  }
  return 0;
}

}  // namespace feedscope::iso
