#include "core/program/heidenhain/language/iso_reader.h"

#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

namespace {

/// Moves after "N20"; true if "/" hides the block.
bool skip_block_number(Scanner& scanner) {
  const bool hidden = scanner.take('/');
  if (letters::to_upper(scanner.peek()) == 'N' && letters::is_digit(scanner.peek_at(1))) {
    scanner.take('N');
    scanner.skip_digits();
  }
  return scanner.take('/') || hidden;
}

bool names_unit(std::string_view text) {
  return text.find("G70") != std::string_view::npos || text.find("G71") != std::string_view::npos;
}

}  // namespace

HeidenhainIsoReader::HeidenhainIsoReader(std::shared_ptr<const SourceText> source, const ReadOptions& options,
                                         Progress* progress)
    : StatementReader(std::move(source), options, progress, Dialect::heidenhain_iso,
                      [this](std::string_view line) { return label_on(line); }),
      words_(parts().context, parts().labels, parts().tools, parts().m_functions, parts().cycles),
      motions_(parts().context, parts().targets, parts().motions, parts().approaches),
      codes_(parts(), motions_) {}

void HeidenhainIsoReader::run_statement(std::string_view statement) {
  const std::size_t last = statement.find_last_not_of(" \t");
  if (statement[last] == '*') {
    statement = statement.substr(0, last);
  }
  Scanner scanner(statement);
  const bool hidden = skip_block_number(scanner);
  if (scanner.at_end() || scanner.peek() == '*' || (hidden && options().skip_deleted_blocks)) {
    return;
  }
  lines().count_block();
  const std::uint32_t column = scanner.column();
  const char first = letters::to_upper(scanner.peek());
  const char second = scanner.peek_at(1);
  if (scanner.take('%')) {
    run_percent(scanner.rest(), column);
  } else if (first == 'D' && letters::is_digit(second)) {
    run_d_function(scanner, column);
  } else if (first == 'Q') {
    parts().q_functions.assign(scanner);
  } else {
    IsoBlock block;
    block.column = column;
    if (words_.read(scanner, motions_.is_incremental(), block)) {
      run_block(block);
    }
  }
}

std::uint32_t HeidenhainIsoReader::first_word(std::string_view line) {
  Scanner scanner(line.substr(0, line.find(';')));
  skip_block_number(scanner);
  const std::uint32_t column = scanner.column();
  return scanner.at_end() || scanner.peek() == '*' || scanner.peek() == '%' ? 0 : column;
}

std::string HeidenhainIsoReader::label_on(std::string_view line) {
  Scanner scanner(line.substr(0, line.find(';')));
  skip_block_number(scanner);
  if (!scanner.take("G98") || !scanner.take('L')) {
    return {};
  }
  IsoBlock block;
  words_.read_label(scanner, block);
  return *block.label == "0" ? std::string() : *block.label;
}

void HeidenhainIsoReader::run_percent(std::string_view rest, std::uint32_t column) {
  if (!names_unit(rest)) {
    parts().calls.call_program(rest, column);
  } else if (begun_ && lines().call_depth() == 0) {
    parts().calls.end_of_program();
  } else if (lines().call_depth() > 0 && lines().line() > 1) {
    parts().calls.end_of_program();
  } else {
    begun_ = true;
    parts().context.set_inch(rest.find("G70") != std::string_view::npos);
  }
}

void HeidenhainIsoReader::run_d_function(Scanner& scanner, std::uint32_t column) {
  constexpr int system_read = 18;
  scanner.take('D');
  FunctionCall call;
  call.number = take_digits(scanner);
  call.column = column;
  scanner.take(':');
  if (call.number == system_read) {
    parts().system_data.read(scanner, column);
    return;
  }
  if (call.computes()) {
    call.result = take_parameter(scanner);
    if (!call.result || call.result->kind == QName::Kind::text) {
      throw_unread_words(scanner, Message::as_written("D"));
    }
  }
  while ((call.jumps() || call.computes()) && !scanner.at_end()) {
    if (!scanner.take('P')) {
      throw_unread_words(scanner, Message::as_written("D"));
    }
    const int operand = take_digits(scanner);
    if (call.jumps() && operand == 3) {
      call.label = parts().labels.read(scanner);
    } else if (operand == 1 || operand == 2) {
      call.values[static_cast<std::size_t>(operand - 1)] = parts().context.formulas.read_value(scanner);
    } else {
      throw_unread_words(scanner, Message::as_written("D"));
    }
  }
  parts().q_functions.run(call);
}

void HeidenhainIsoReader::run_block(IsoBlock& block) {
  codes_.apply_modes(block);
  if (block.label && !block.has(98)) {
    if (block.repeats.value_or(0) > 0) {
      parts().calls.repeat_from_label(*block.label, *block.repeats, block.column);
    } else {
      parts().calls.call_label(*block.label, block.column);
    }
    return;
  }
  if (block.has(98) && block.label == "0") {
    parts().calls.end_subprogram();
    return;
  }
  if (codes_.run(block)) {
    return;
  }
  if (block.tool.tool || block.tool.speed) {
    run_tool(block);
  }
  motions_.run(block);
}

void HeidenhainIsoReader::run_tool(const IsoBlock& block) {
  ToolCall call = block.tool;
  call.plane = block.has(17)   ? std::optional(Plane::xy)
               : block.has(18) ? std::optional(Plane::zx)
               : block.has(19) ? std::optional(Plane::yz)
                               : std::nullopt;
  if (call.tool && block.motion.feed_word == FeedWord::value) {
    call.feed = block.motion.feed;
    call.feed_column = block.motion.feed_column;
  }
  parts().tools.call(call);
}

}  // namespace feedscope::heidenhain
