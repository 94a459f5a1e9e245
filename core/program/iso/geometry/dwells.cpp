#include "core/program/iso/geometry/dwells.h"

#include "core/program/iso/language/printer_words.h"

namespace feedscope::iso {

namespace {

/// Controls that read milliseconds have no shorter dwells, those that read seconds no longer ones.
constexpr double shortest_plain_p = 50;

}  // namespace

bool Dwells::is_printer() {
  if (!is_printer_) {
    is_printer_ = dialect() == Dialect::grbl && is_for_printer(*lines().main_text());
  }
  return *is_printer_;
}

/// Warns of a dwell that is probably too long to be in seconds.
void Dwells::check_seconds(const Word& word, bool milliseconds) const {
  if (milliseconds || word.has_point || word.value < shortest_plain_p) {
    return;
  }
  if (!is_linuxcnc() && (word.letter == 'X' || word.letter == 'U')) {
    report(Severity::warning, "decimal-point", 1, word.column, [&] {
      return Text{message(NC_("core", "{}{} without a decimal point is used as {} seconds"), word.letter,
                          word.value, word.value),
                  NC_("core", "many controls use it in units of 0.001 s; write a decimal point")};
    });
  } else if (is_linuxcnc() && word.letter == 'P') {
    report(Severity::info, "dwell-unit", 1, word.column, [&] {
      return Text{
          message(NC_("core", "P{} is used as {} seconds, as in {}"), word.value, word.value,
                  info_of(dialect()).title),
          message(NC_("core", "for a control that takes milliseconds, write P{}"), word.value / 1000)};
    });
  }
}

void Dwells::run() {
  for (const char letter : {'P', 'X', 'U', 'F', 'S'}) {
    if (!words_.has(letter) || (letter == 'S' && !is_printer())) {
      continue;
    }
    const Word& word = words_[letter];
    if (word.value < 0) {
      report(Severity::error, "dwell-time", 0, word.column, [&] {
        return Text{message(NC_("core", "dwell time {}{} is negative"), letter, word.value),
                    NC_("core", "the dwell is skipped")};
      });
      return;
    }
    const bool milliseconds = letter == 'P' && (is_printer() || (!word.has_point && !is_linuxcnc()));
    if (milliseconds && dialect() == Dialect::iso && word.value > 0 && word.value < shortest_plain_p) {
      report(Severity::info, "dwell-unit", 0, word.column, [&] {
        return Text{message(NC_("core", "P{} without a decimal point is used as {} milliseconds"), word.value,
                            word.value),
                    message(NC_("core", "write P{}.0 for seconds"), word.value)};
      });
    }
    check_seconds(word, milliseconds);
    if (word.value > 0) {
      path().dwell(milliseconds ? word.value / 1000 : word.value);
    }
    return;
  }
  report(Severity::error, "dwell-time", 1, words_.dwell, [] {
    return Text{NC_("core", "G4 without a time"),
                NC_("core", "the dwell is skipped; write P, X or U with the time")};
  });
}

}  // namespace feedscope::iso
