// The part of IsoReader that tells what it could not read.
#include <fmt/format.h>

#include <string>

#include "core/program/iso/iso_reader.h"
#include "core/program/text/message.h"

namespace feedscope {

namespace {

constexpr std::string_view not_moved = "the block does not move; correct the word or write a plain number";

DiagnosticLog::Text text_of(const Fault& fault, std::string_view written) {
  switch (fault.kind) {
    case FaultKind::malformed_number:
      return {fmt::format("{} has no readable number", quoted(written)), std::string(not_moved)};
    case FaultKind::number_range:
      return {fmt::format("{} is beyond the largest number, 1000000000", quoted(written)),
              std::string(not_moved)};
    case FaultKind::unclosed_comment:
      return {fmt::format("the comment {} is not closed", quoted(written)),
              "the rest of the line is taken for the comment; add the closing bracket"};
    case FaultKind::character:
      break;
  }
  const auto byte = static_cast<unsigned char>(written.front());
  const bool plain = byte > ' ' && byte <= '~';
  return {
      fmt::format("{} does not start a word", plain ? quoted(written) : fmt::format("byte 0x{:02X}", byte)),
      "the rest of the line is not read and the block does not move; remove the character"};
}

std::string_view code_of(FaultKind kind) {
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

void IsoReader::report_faults(const Block& block) {
  for (const Fault& fault : block.faults) {
    report(Severity::error, code_of(fault.kind), 0, fault.column,
           [&] { return text_of(fault, block.text_of(fault)); });
  }
}

void IsoReader::report_unread(const GCode& code, const Word& word) {
  if (!code.subject.empty()) {
    report(code.severity, "unread-g", code.number, word.column, [&] {
      return Text{fmt::format("{} ({}) is not read", g_name(code.number), code.subject),
                  std::string(code.effect)};
    });
  }
}

void IsoReader::check_rotary() {
  constexpr std::string_view axes = "ABCUVW";
  if (words_.own_words || words_.dwell > 0 || !words_.has_any(axes)) {
    return;
  }
  const bool cuts = state_.motion == MotionMode::line || state_.motion == MotionMode::arc_cw ||
                    state_.motion == MotionMode::arc_ccw || state_.motion == MotionMode::spline;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!words_.has(axes[i])) {
      continue;
    }
    const Word& word = words_[axes[i]];
    const double target = state_.incremental ? state_.further_axes[i] + word.value : word.value;
    if (target != state_.further_axes[i]) {
      const bool rotary = i < 3;
      note_other_axis(axes.substr(i, 1), target, rotary && !cuts ? AxisMotion::positions : AxisMotion::cuts,
                      word.column);
    }
    state_.further_axes[i] = target;
  }
}

void IsoReader::check_unused() {
  const bool is_arc = state_.motion == MotionMode::arc_cw || state_.motion == MotionMode::arc_ccw;
  const bool own_letters = state_.motion == MotionMode::unread || state_.motion == MotionMode::cycle ||
                           state_.motion == MotionMode::spline;
  if (words_.other_codes || own_letters) {
    return;
  }
  if (words_.has('E')) {
    report(Severity::info, "unused-word", 'E', words_['E'].column, [] {
      return Text{"E (extruder) is not read", "it does not change the path"};
    });
  }
  const std::string_view unused = is_arc ? "LQ" : "IJKRPLQ";
  if (!(is_arc ? words_.has_any("LQ") : words_.has_any("IJKRPLQ"))) {
    return;
  }
  for (const char letter : unused) {
    if (words_.has(letter)) {
      report(Severity::warning, "unused-word", letter, words_[letter].column, [&] {
        return Text{fmt::format("{}{} has no meaning in this block", letter, words_[letter].value),
                    is_arc ? "it is left out" : "it is left out; is a G2 or G3 missing?"};
      });
    }
  }
}

}  // namespace feedscope
