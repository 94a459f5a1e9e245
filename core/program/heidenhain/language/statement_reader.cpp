#include "core/program/heidenhain/language/statement_reader.h"

namespace feedscope::heidenhain {

void StatementReader::run_line(std::string_view line) {
  const std::string_view statement = parts_.context.statement.add(line);
  if (parts_.context.statement.is_joined()) {
    run_joined(statement);
  } else if (!statement.empty()) {
    run_statement(statement);
  }
}

void StatementReader::run_joined(std::string_view statement) {
  if (statement.empty()) {
    return;
  }
  try {
    run_statement(statement);
  } catch (const ReadFault& fault) {
    parts_.context.report(Severity::error, fault.code, 0, fault.column, [&] {
      return Text{fault.message, fault.hint};
    });
  }
  parts_.context.statement.clear();
}

void StatementReader::run_out() {
  run_joined(parts_.context.statement.joined());
  parts_.calls.end_of_program();
}

void StatementReader::finish() {
  run_joined(parts_.context.statement.joined());
  parts_.context.contour.flush();
}

}  // namespace feedscope::heidenhain
