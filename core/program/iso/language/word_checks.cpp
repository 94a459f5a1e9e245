#include "core/program/iso/language/word_checks.h"

#include <algorithm>

namespace feedscope::iso {

void WordChecks::run() {
  check_other_axes();
  orient_tool();
  check_unused();
}

/// Missing components are zero.
void WordChecks::orient_tool() {
  const bool cuts = modal_.motion == MotionMode::line;
  if (!modal_.tool_vectors || words_.own_words || words_.dwell > 0 || !words_.has_any("IJK") ||
      !(cuts || modal_.motion == MotionMode::rapid)) {
    return;
  }
  Vec3 direction = Vec3::Zero();
  std::uint32_t column = 0;
  for (int i = 0; i < 3; ++i) {
    if (const char letter = "IJK"[i]; words_.has(letter)) {
      direction[i] = words_[letter].value;
      column = column == 0 ? words_[letter].column : column;
    }
  }
  const std::optional<Vec3> tool =
      machining_.tool_direction(direction, NC_("core", "I, J and K"), "K1", column);
  if (!tool) {
    return;
  }
  const AxisBlock block = beside_motion(!words_.has_any("XYZ"), !cuts);
  machining_.other_axes.orient_tool(*tool, cuts ? AxisMotion::at_tip : AxisMotion::positions, column, block);
}

void WordChecks::check_other_axes() {
  constexpr std::string_view axes = "ABCUVW";
  if (words_.own_words || words_.dwell > 0 || !words_.has_any(axes)) {
    return;
  }
  const bool cuts =
      modal_.motion == MotionMode::line || modal_.is_arc() || modal_.motion == MotionMode::spline;
  const bool alone = !words_.has_any("XYZIJKRUVW") && modal_.motion != MotionMode::cycle;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!words_.has(axes[i])) {
      continue;
    }
    const Word& word = words_[axes[i]];
    const double target = modal_.incremental ? other_axes_[i] + word.value : word.value;
    if (target != other_axes_[i]) {
      const bool rotary = i < 3;
      machining_.other_axes.move(axes.substr(i, 1), target,
                                 rotary && !cuts ? AxisMotion::positions : AxisMotion::cuts, word.column,
                                 beside_motion(alone, !cuts));
    }
    other_axes_[i] = target;
  }
}

/// F of Fanuc and similar controls applies along all axes, with a degree as a millimetre or inch; LinuxCNC's
/// along X, Y and Z.
AxisBlock WordChecks::beside_motion(bool alone, bool rapid) const {
  AxisBlock block = turning_alone(path(), modal_.to_mm(1), rapid);
  block.alone = alone;
  block.at_tip = modal_.tool_centre_point || modal_.tip_kinematics;
  block.per_degree = is_linuxcnc() || path().feed_mode() == FeedMode::inverse_time ? 0 : modal_.to_mm(1);
  return block;
}

void WordChecks::check_unused() const {
  const bool is_arc = modal_.is_arc();
  const bool own_letters = modal_.motion == MotionMode::unread || modal_.motion == MotionMode::cycle ||
                           modal_.motion == MotionMode::spline;
  if (words_.other_codes || own_letters) {
    return;
  }
  const bool extrudes_alone = !words_.has_any("XYZ") && modal_.motion != MotionMode::none;
  if (words_.has('E') && extrudes_alone) {
    report(Severity::info, "unused-word", 'E' + 1000, words_['E'].column, [] {
      return Text{NC_("core", "a move of the extruder alone (E) takes time"),
                  NC_("core", "only the model klipper counts it")};
    });
  } else if (words_.has('E')) {
    report(Severity::info, "unused-word", 'E', words_['E'].column, [] {
      return Text{NC_("core", "E (extruder) is not supported"), NC_("core", "it does not change the path")};
    });
  }
  const std::string_view unused = is_arc ? "LQ" : modal_.tool_vectors ? "RPLQ" : "IJKRPLQ";
  if (std::ranges::none_of(unused, [&](char letter) { return words_.has(letter); })) {
    return;
  }
  for (const char letter : unused) {
    if (words_.has(letter)) {
      report(Severity::warning, "unused-word", letter, words_[letter].column, [&] {
        return Text{message(NC_("core", "{}{} has no meaning in this block"), letter, words_[letter].value),
                    is_arc ? NC_("core", "it is skipped")
                           : NC_("core", "it is ignored; check whether G2 or G3 is missing")};
      });
    }
  }
}

}  // namespace feedscope::iso
