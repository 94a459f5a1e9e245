#include "core/program/iso/geometry/path_modes.h"

#include "core/machine/contour_tolerance.h"

namespace feedscope::iso {

void PathModes::apply(const GCode& code) {
  constexpr int exact_stop_of_block = 90;
  constexpr int exact_path = 610;
  constexpr int exact_stop = 611;
  constexpr int corner_override = 620;
  constexpr int tapping = 630;
  constexpr int continuous = 640;
  constexpr int smoothness = 1870;
  constexpr double high_speed = 10000;
  constexpr double smooth_interpolation = 2;
  PathControl control = path().path_control();
  const auto switched = [&](char letter, double on) {
    if (words_.has(letter)) {
      control.look_ahead = words_[letter].value >= on ? Switch::on : Switch::off;
    }
  };
  switch (code.number) {
    case exact_stop_of_block:
      words_.exact_stop = true;
      return;
    case exact_path:
    case exact_stop:
      control.mode = PathMode::exact_stop;
      control.exact_path = code.number == exact_path;
      break;
    case continuous:
      control.mode = PathMode::continuous;
      control.exact_path = false;
      set_tolerances(control);
      break;
    case corner_override:
    case tapping:
      control.mode = PathMode::continuous;
      control.exact_path = false;
      break;
    case smoothness:
      control.contour_tolerance = tolerance('E', "G187");
      report_mode('P', NC_("core", "G187 (smoothness)"));
      break;
    case 50:
      switched('P', high_speed);
      break;
    case 51:
      report_mode('R', NC_("core", "G5.1 (machining condition from speed to accuracy)"));
      if (words_.has('Q') && words_['Q'].value == smooth_interpolation) {
        control.compressor = control.look_ahead = Switch::machine;
        report_smooth_interpolation();
        break;
      }
      switched('Q', 1);
      if (words_.has('Q')) {
        control.compressor = control.look_ahead;
      }
      break;
    case 80:
      switched('P', 1);
      break;
    default:
      break;
  }
  path().set_path_control(control);
}

/// Reports a word that chooses between sets of parameters of the control.
void PathModes::report_mode(char letter, Translatable of) const {
  if (words_.has(letter)) {
    const Word& word = words_[letter];
    report(Severity::info, "machining-mode", letter, word.column, [&] {
      return Text{
          message(NC_("core", "{}{} of {} changes nothing in the simulation"), letter, word.value, of),
          NC_("core",
              "its parameters exist only in the control; set acceleration and jerk of the machine instead")};
    });
  }
}

/// Fanuc, Series 15i/150i-MA, Operator's Manual, 4.16: a curve where the radius is large, lines at corners.
void PathModes::report_smooth_interpolation() const {
  report(Severity::warning, "unread-g", 'Q', words_['Q'].column, [] {
    return Text{NC_("core", "G5.1 Q2 (smooth interpolation) is not supported"),
                NC_("core",
                    "its blocks are run as lines; the setting compressor=on smooths them within the "
                    "tolerance, but not by the control's own curve")};
  });
}

std::optional<double> PathModes::tolerance(char letter, std::string_view of) const {
  if (!words_.has(letter)) {
    return std::nullopt;
  }
  const Word& word = words_[letter];
  if (word.value < 0) {
    report(Severity::error, "path-tolerance", 0, word.column, [&] {
      return Text{message(NC_("core", "tolerance {}{} of {} is negative"), letter, word.value, of),
                  NC_("core", "it is ignored; write a tolerance of zero or more")};
    });
    return std::nullopt;
  }
  const double tolerance = modal_.to_mm(word.value);
  if (is_too_small(tolerance)) {
    report(Severity::warning, "path-tolerance", 1, word.column, [&] {
      return too_small_text(message(NC_("core", "tolerance {}{} of {}"), letter, plain_text(word.value), of));
    });
    return least_tolerance;
  }
  return tolerance;
}

void PathModes::set_tolerances(PathControl& control) const {
  control.contour_tolerance = tolerance('P', "G64");
  const std::optional<double> joining = tolerance('Q', "G64");
  control.compaction_tolerance = joining ? joining : control.contour_tolerance;
  control.compaction = Switch::machine;
  if (is_linuxcnc() || control.compaction_tolerance) {
    const bool joins = control.compaction_tolerance.value_or(0) > 0;
    control.compaction = joins ? Switch::on : Switch::off;
  }
}

}  // namespace feedscope::iso
