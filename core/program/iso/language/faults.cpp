#include "core/program/iso/language/faults.h"

#include <fmt/format.h>

#include <string>

#include "core/program/text/message.h"

namespace feedscope::iso {

namespace {

constexpr std::string_view not_moved = "the block does not move; correct the word or write a plain number";

DiagnosticLog::Text text_of(const Fault& fault, std::string_view written) {
  switch (fault.kind) {
    case FaultKind::malformed_number:
      return {fmt::format("{} has no valid number", in_quotes(written)), std::string(not_moved)};
    case FaultKind::number_range:
      return {fmt::format("{} is above the largest number, 1000000000", in_quotes(written)),
              std::string(not_moved)};
    case FaultKind::unclosed_comment:
      return {fmt::format("the comment {} is not closed", in_quotes(written)),
              "the rest of the line is used as the comment; add the closing bracket"};
    case FaultKind::character:
      break;
  }
  const auto byte = static_cast<unsigned char>(written.front());
  const bool plain = byte > ' ' && byte <= '~';
  return {fmt::format("{} does not start a word",
                      plain ? in_quotes(written) : fmt::format("byte 0x{:02X}", byte)),
          "the rest of the line is skipped and the block does not move; remove the character"};
}

MessageCode code_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::malformed_number:
      return "malformed-number";
    case FaultKind::number_range:
      return "number-range";
    case FaultKind::unclosed_comment:
      return "unclosed-comment";
    case FaultKind::character:
      break;
  }
  return "unknown-character";
}

}  // namespace

void report_faults(const Machining& machining, const Block& block) {
  for (const Fault& fault : block.faults) {
    machining.report(Severity::error, code_of(fault.kind), 0, fault.column,
                     [&] { return text_of(fault, block.text_of(fault)); });
  }
}

}  // namespace feedscope::iso
