#include "core/program/heidenhain/language/unsupported_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/program/text/message.h"

namespace feedscope::heidenhain {

namespace {

/// Statements that are known but not simulated.
struct UnreadStatement {
  std::string_view name;
  Severity severity = Severity::error;
  std::string_view subject;
  std::string_view effect;
};

constexpr std::string_view positions_missing = "its motion is skipped";

constexpr auto unread_statements = std::to_array<UnreadStatement>({
    {"PLANE", Severity::error, "this form of tilted working plane", "the path is shown untilted"},
    {"FUNCTION", Severity::info, "function of the machine", "the path is shown as programmed"},
    {"POLARKIN", Severity::error, "polar kinematics", "the path is shown as programmed"},
    {"FL", Severity::error, "free contour", positions_missing},
    {"FLT", Severity::error, "free contour", positions_missing},
    {"FC", Severity::error, "free contour", positions_missing},
    {"FCT", Severity::error, "free contour", positions_missing},
    {"FPOL", Severity::error, "free contour", positions_missing},
    {"FSELECT", Severity::error, "free contour", positions_missing},
    {"SPL", Severity::error, "spline", positions_missing},
    {"TCH", Severity::warning, "touch probe cycle", positions_missing},
    {"MODE", Severity::error, "another machining mode", "its path is shown as in milling mode"},
    {"SEL", Severity::warning, "selection of a table, pattern or program", "what it selects is not known"},
    {"CONTOUR", Severity::error, "contour definition", positions_missing},
    {"OPEN", Severity::info, "file access", "it does not change the path"},
});

const UnreadStatement* find_unread(std::string_view name) {
  const auto known = std::find_if(unread_statements.begin(), unread_statements.end(),
                                  [name](const UnreadStatement& s) { return letters::same(s.name, name); });
  return known == unread_statements.end() ? nullptr : &*known;
}

}  // namespace

bool UnsupportedStatements::report_known(std::string_view name, std::uint32_t column) {
  const UnreadStatement* const known = find_unread(name);
  if (known == nullptr) {
    return false;
  }
  if (std::find(reported_.begin(), reported_.end(), known->name) != reported_.end()) {
    return true;
  }
  reported_.push_back(known->name);
  report(known->severity, "unread-statement", static_cast<int>(known - unread_statements.data()) + 1, column,
         [&] {
           return Text{fmt::format("{} ({}) is not supported", known->name, known->subject),
                       fmt::format("{}; reported once", known->effect)};
         });
  return true;
}

void UnsupportedStatements::report_unknown(std::string_view statement, std::uint32_t column) {
  report(Severity::error, "unknown-statement", 0, column, [&] {
    return Text{fmt::format("{} is not a statement of this dialect", in_quotes(statement.substr(column - 1))),
                "it is skipped; if the program has another dialect, give it with --dialect"};
  });
}

}  // namespace feedscope::heidenhain
