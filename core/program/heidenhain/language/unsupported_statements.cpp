#include "core/program/heidenhain/language/unsupported_statements.h"

#include <algorithm>
#include <array>

#include "core/program/text/message.h"

namespace feedscope::heidenhain {

namespace {

/// Statements that are known but not simulated.
struct UnreadStatement {
  std::string_view name;
  Severity severity = Severity::error;
  Translatable subject;
  Translatable effect;
};

constexpr Translatable positions_missing = NC_("core", "its motion is skipped");

constexpr auto unread_statements = std::to_array<UnreadStatement>({
    {"PLANE", Severity::error, NC_("core", "this form of tilted working plane"),
     NC_("core", "the path is shown untilted")},
    {"FUNCTION", Severity::info, NC_("core", "function of the machine"),
     NC_("core", "the path is shown as programmed")},
    {"POLARKIN", Severity::error, NC_("core", "polar kinematics"),
     NC_("core", "the path is shown as programmed")},
    {"FL", Severity::error, NC_("core", "free contour"), positions_missing},
    {"FLT", Severity::error, NC_("core", "free contour"), positions_missing},
    {"FC", Severity::error, NC_("core", "free contour"), positions_missing},
    {"FCT", Severity::error, NC_("core", "free contour"), positions_missing},
    {"FPOL", Severity::error, NC_("core", "free contour"), positions_missing},
    {"FSELECT", Severity::error, NC_("core", "free contour"), positions_missing},
    {"SPL", Severity::error, NC_("core", "spline"), positions_missing},
    {"TCH", Severity::warning, NC_("core", "touch probe cycle"), positions_missing},
    {"MODE", Severity::error, NC_("core", "another machining mode"),
     NC_("core", "its path is shown as in milling mode")},
    {"SEL", Severity::warning, NC_("core", "selection of a table, pattern or program"),
     NC_("core", "what it selects is not known")},
    {"CONTOUR", Severity::error, NC_("core", "contour definition"), positions_missing},
    {"OPEN", Severity::info, NC_("core", "file access"), NC_("core", "it does not change the path")},
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
           return Text{message(NC_("core", "{} ({}) is not supported"), known->name, known->subject),
                       message(NC_("core", "{}; reported once"), known->effect)};
         });
  return true;
}

void UnsupportedStatements::report_unknown(std::string_view statement, std::uint32_t column) {
  report(Severity::error, "unknown-statement", 0, column, [&] {
    return Text{message(NC_("core", "{} is not a statement of this dialect"),
                        in_quotes(statement.substr(column - 1))),
                NC_("core", "it is skipped; if the program has another dialect, give it with --dialect")};
  });
}

}  // namespace feedscope::heidenhain
