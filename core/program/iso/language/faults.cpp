#include "core/program/iso/language/faults.h"

#include <string>

#include "core/program/text/message.h"

namespace feedscope::iso {

namespace {

constexpr Translatable not_moved =
    NC_("core", "the block does not move; correct the word or write a plain number");

DiagnosticLog::Text text_of(const Fault& fault, std::string_view written) {
  switch (fault.kind) {
    case FaultKind::malformed_number:
      return {message(NC_("core", "{} has no valid number"), in_quotes(written)), not_moved};
    case FaultKind::number_range:
      return {message(NC_("core", "{} is above the largest number, 1000000000"), in_quotes(written)),
              not_moved};
    case FaultKind::unclosed_comment:
      return {message(NC_("core", "the comment {} is not closed"), in_quotes(written)),
              NC_("core", "the rest of the line is used as the comment; add the closing bracket")};
    case FaultKind::character:
      break;
  }
  const auto byte = static_cast<unsigned char>(written.front());
  const bool plain = byte > ' ' && byte <= '~';
  return {
      message(NC_("core", "{} does not start a word"),
              plain ? Message::as_written(in_quotes(written)) : message(NC_("core", "byte 0x{:02X}"), byte)),
      NC_("core", "the rest of the line is skipped and the block does not move; remove the character")};
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
