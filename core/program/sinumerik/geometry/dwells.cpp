#include "core/program/sinumerik/geometry/dwells.h"

namespace feedscope::sinumerik {

void Dwells::run() {
  const char letter = words_.has('F') ? 'F' : 'S';
  if (!words_.has_any("FS")) {
    report(Severity::error, "dwell-time", 1, functions_.own_column, [] {
      return Text{NC_("core", "G4 without a time"),
                  NC_("core", "the dwell is skipped; write F with seconds or S with revolutions")};
    });
    return;
  }
  const BlockWords::Value& word = words_[letter];
  double seconds = word.value;
  if (letter == 'S') {
    const double speed = path().spindle_speed();
    if (speed <= 0) {
      report(Severity::error, "dwell-time", 2, word.column, [&] {
        return Text{message(NC_("core", "a dwell of {} revolutions without a spindle speed"), word.value),
                    NC_("core", "the dwell is skipped; write S in a block before it")};
      });
      return;
    }
    seconds /= speed;
  }
  if (seconds < 0) {
    report(Severity::error, "dwell-time", 0, word.column, [&] {
      return Text{message(NC_("core", "dwell time {}{} is negative"), letter, word.value),
                  NC_("core", "the dwell is skipped")};
    });
  } else if (seconds > 0) {
    path_modes_.use(false);
    path().dwell(seconds);
  }
}

}  // namespace feedscope::sinumerik
