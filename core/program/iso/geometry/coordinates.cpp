#include "core/program/iso/geometry/coordinates.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"
#include "core/program/text/message.h"

namespace feedscope::iso {

namespace {

constexpr int numbered = 541;           ///< G54.1 P
constexpr int numbered_of_haas = 1540;  ///< G154 P

}  // namespace

Coordinates::Coordinates(Context& context, const Targets& targets) : Part(context), targets_(targets) {
  use_given_offsets();
}

void Coordinates::run(int code, std::uint32_t column) {
  if (run_frame_code(code, column)) {
    set_frame();
  } else {
    select_work_offset(code, column);
  }
}

void Coordinates::set_frame() {
  path().set_frame(frames_.frame());
  path().set_machine_axes(frames_.work_offset_in_force().set);
}

bool Coordinates::run_frame_code(int code, std::uint32_t column) {
  switch (code) {
    case 500:
      frames_.end_scale();
      check_turning(column);
      return true;
    case 501:
    case 511:
      mirror(code == 511);
      return true;
    case 510:
      scale(column);
      return true;
    case 520:
      is_linuxcnc() ? frames_.set_preset(targets_.axes(frames_.preset()))
                    : frames_.set_local_shift(targets_.axes(frames_.local_shift()));
      return true;
    case 680:
      rotate(column);
      return true;
    case 682:
      tilt(column);
      return true;
    case 690:
      frames_.end_rotation();
      return true;
    case 920:
      set_position(column);
      return true;
    case 921:
      frames_.forget_position();
      return true;
    case 922:
      frames_.hold_position();
      return true;
    case 923:
      frames_.restore_position();
      return true;
    default:
      return false;
  }
}

/// G92 after a move to a machine position: the shift from the previous coordinates to the new ones is not
/// known.
void Coordinates::set_position(std::uint32_t column) {
  const Vec3 here = path().position();
  frames_.set_position(here, targets_.axes(here));
  if (path().name_place(targets_.named_axes()) && path().has_moved()) {
    report(Severity::warning, "unknown-position", 2, column, [] {
      return Text{
          NC_("core", "G92 gives coordinates to a position that is not known"),
          NC_("core", "the path continues where the axis was before the move to the machine position")};
    });
  }
}

void Coordinates::use_given_offsets() {
  const WorkOffsets& offsets = machining_.options.offsets;
  for (const auto& [name, zero] : offsets.all()) {
    for (const int key : Frames::work_offset_keys) {
      if (WorkOffsets::key(g_name(key)) == name) {
        frames_.set_work_offset(key, {zero, 0});
      }
    }
    const std::string_view further = " P";
    const std::size_t at = name.find(further);
    const bool is_further =
        at != std::string::npos && (name.substr(0, at) == g_name(numbered) || name.substr(0, at) == "G154");
    if (is_further) {
      const int number = std::stoi(name.substr(at + further.size()));
      frames_.set_work_offset(Frames::further_work_offset(number), {zero, 0});
    }
  }
  if (!offsets.empty()) {
    set_frame();
  }
}

void Coordinates::select_work_offset(int code, std::uint32_t column) {
  int key = code;
  if (code == numbered || code == numbered_of_haas) {
    const std::optional<int> further = offset_key(column, true);
    if (!further) {
      return;
    }
    key = *further;
  }
  const bool known = frames_.work_offset(key) != nullptr;
  const bool known_before = frames_.work_offset(frames_.key_in_force()) != nullptr;
  if (path().has_moved() && modal_.work_offset != 0 && modal_.work_offset != key &&
      !(known && known_before)) {
    report(Severity::warning, "work-offset", key, column, [&] {
      return Text{message(NC_("core", "{} is selected after motion in {}"), Frames::name_of(key),
                          Frames::name_of(modal_.work_offset)),
                  missing_offset_hint(Frames::name_of(known ? modal_.work_offset : key))};
    });
  }
  use_work_offset(key);
  set_frame();
}

void Coordinates::use_work_offset(int key) {
  modal_.work_offset = key;
  frames_.select_work_offset(key);
  path().use_work_offset(Frames::name_of(key), frames_.zero_of(key));
}

void Coordinates::restore_work_offset(int key) {
  if (key != 0 && key != modal_.work_offset) {
    use_work_offset(key);
    set_frame();
  }
}

std::optional<int> Coordinates::offset_key(std::uint32_t column, bool further) const {
  constexpr double max_further = 300;
  const double number = words_.value_or('P', 0);
  const double most = further ? max_further : static_cast<double>(Frames::work_offset_keys.size());
  const double least = further ? 1 : 0;
  if (!(number >= least && number <= most && number == std::floor(number))) {
    report(Severity::error, "offset-number", 0, words_.column_or('P', column), [&] {
      return Text{message(NC_("core", "P{} is not a work offset number from {} to {}"), number, least, most),
                  NC_("core", "the block has no effect on the path")};
    });
    return std::nullopt;
  }
  const int whole = static_cast<int>(number);
  if (further) {
    return Frames::further_work_offset(whole);
  }
  return whole == 0 ? frames_.key_in_force() : Frames::work_offset_keys[static_cast<std::size_t>(whole - 1)];
}

Frames::WorkOffset Coordinates::offset_or_zero(int key) const {
  const Frames::WorkOffset* const known = frames_.work_offset(key);
  return known == nullptr ? Frames::WorkOffset{} : *known;
}

std::optional<double> Coordinates::offset_coordinate(int key, int axis) const {
  const Frames::WorkOffset* const known = frames_.work_offset(key);
  return known == nullptr ? std::nullopt : std::optional(known->shift[axis]);
}

void Coordinates::set_offset_coordinate(int key, int axis, double value) {
  Frames::WorkOffset offset = offset_or_zero(key);
  offset.shift[axis] = value;
  offset.set[static_cast<std::size_t>(axis)] = true;
  store_work_offset(key, offset);
  set_frame();
}

void Coordinates::set_work_offset(bool further, std::uint32_t column) {
  const std::optional<int> key = offset_key(column, further);
  if (!key) {
    return;
  }
  Frames::WorkOffset offset = offset_or_zero(*key);
  const bool adds = modal_.incremental && dialect() == Dialect::fanuc;
  offset.shift = adds ? Vec3(offset.shift + targets_.axes(Vec3::Zero())) : targets_.axes(offset.shift);
  for (std::size_t axis = 0; axis < offset.set.size(); ++axis) {
    offset.set[axis] = offset.set[axis] || (words_.has(axis_letters[axis]) && !adds);
  }
  if (words_.has('R')) {
    offset.angle = units::from_deg(words_['R'].value);
  }
  store_work_offset(*key, offset);
  set_frame();
}

void Coordinates::store_work_offset(int key, const Frames::WorkOffset& offset) {
  frames_.set_work_offset(key, offset);
  if (key == frames_.key_in_force()) {
    path().set_zero_in_use(offset.shift);
  }
}

void Coordinates::preset_work_offset(std::uint32_t column) {
  const std::optional<int> key = offset_key(column, false);
  if (!key) {
    return;
  }
  Frames there = frames_;
  there.select_work_offset(*key);
  Frames::WorkOffset offset = there.work_offset_in_force();
  const Vec3 shown = path().shown_position();
  const Vec3 preset = targets_.axes(there.frame().to_programmed(shown));
  offset.shift += shown - there.frame().to_shown(preset);
  const std::array<bool, 3>& known = frames_.work_offset_in_force().set;
  for (std::size_t axis = 0; axis < offset.set.size(); ++axis) {
    offset.set[axis] = words_.has(axis_letters[axis]) ? known[axis] : offset.set[axis];
  }
  store_work_offset(*key, offset);
  set_frame();
}

void Coordinates::rotate(std::uint32_t column) {
  if (lacks("rotation-angle", 'R', 680, column,
            NC_("core", "the path is shown without it; write R with the angle"))) {
    return;
  }
  if (words_.has_any("IJK")) {
    rotate_in_space(column);
    return;
  }
  const double angle = units::from_deg(words_['R'].value);
  const Vec3 here = frames_.tilted().to_programmed(path().shown_position());
  frames_.rotate(modal_.plane, targets_.axes(here), modal_.incremental ? frames_.angle() + angle : angle);
}

/// G68 X Y Z I J K: about the axis (I, J, K) through X Y Z, counter-clockwise seen against it. A second one
/// turns the result of the first.
void Coordinates::rotate_in_space(std::uint32_t column) {
  Vec3 axis = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const char letter = "IJK"[i];
    axis[i] = words_.has(letter) ? words_[letter].value : 0;
  }
  if (axis.isZero()) {
    report(Severity::error, "rotation-angle", 1, column, [] {
      return Text{NC_("core", "G68 with I0 J0 K0 has no rotation axis"),
                  NC_("core", "the path is shown without it")};
    });
    return;
  }
  const Vec3 here = frames_.rotated().to_programmed(path().shown_position());
  frames_.tilt(
      CoordinateFrame::rotation(axis.normalized(), units::from_deg(words_['R'].value), targets_.axes(here)));
  report_tilt(column);
}

/// G68.2 X Y Z I J K: replaces the plane by one with its origin at X Y Z. P0: turned by the Euler angles I
/// about Z, J about the new X, K about the new Z. P1 Q123: turned by I, J and K about the X, Y and Z of the
/// workpiece in the order of Q. Finally turned by R about its own Z.
void Coordinates::tilt(std::uint32_t column) {
  frames_.end_rotation();
  const auto angle_of = [&](char letter) {
    return words_.has(letter) ? units::from_deg(words_[letter].value) : 0;
  };
  constexpr std::string_view letters = "IJK";
  const double kind = words_.has('P') ? words_['P'].value : 0;
  const std::string order = words_.has('Q') ? fmt::format("{:.0f}", words_['Q'].value) : "123";
  std::string sorted = order;
  std::sort(sorted.begin(), sorted.end());
  if ((kind != 0 && kind != 1) || sorted != "123") {
    report(Severity::error, "unread-g", 682, words_.has('P') ? words_['P'].column : column, [&] {
      return Text{message(NC_("core",
                              "G68.2 P{} (tilted working plane by points, vectors or projection angles) is "
                              "not supported"),
                          kind),
                  NC_("core", "the path is shown without it")};
    });
    return;
  }
  CoordinateFrame turned;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    if (kind == 0) {
      turned =
          turned * CoordinateFrame::rotation(i == 1 ? Vec3::UnitX() : Vec3::UnitZ(), angle_of(letters[i]));
    } else {
      const int axis = order[i] - '1';
      turned =
          CoordinateFrame::rotation(Vec3::Unit(axis), angle_of(letters[static_cast<std::size_t>(axis)])) *
          turned;
    }
  }
  frames_.tilt(CoordinateFrame::shift(targets_.axes(Vec3::Zero())) * turned *
               CoordinateFrame::rotation(Vec3::UnitZ(), angle_of('R')));
  report_tilt(column);
}

void Coordinates::report_tilt(std::uint32_t column) const {
  report(Severity::warning, "tilted-plane", 0, column, [] {
    return Text{NC_("core", "the working plane is tilted"),
                NC_("core",
                    "the path is shown on the workpiece; on a machine that rotates the workpiece the axes "
                    "move differently")};
  });
}

/// G50 with S limits the spindle of a lathe.
void Coordinates::check_turning(std::uint32_t column) const {
  if (!words_.has('S') || is_linuxcnc()) {
    return;
  }
  report(Severity::warning, "turning-program", 0, column, [] {
    return Text{
        NC_("core", "G50 with S belongs to a turning program"),
        NC_("core",
            "turning is not supported: X is used as a radius, G98 and G99 as those of drilling cycles")};
  });
}

double Coordinates::scale_factor(const Word& word) const {
  constexpr double min_in_thousandths = 50;
  const bool thousandths = !word.has_point && std::abs(word.value) >= min_in_thousandths;
  const double factor = thousandths ? word.value / 1000 : word.value;
  if (factor == 0) {
    report(Severity::error, "scale-factor", 0, word.column, [&] {
      return Text{message(NC_("core", "scale factor {}{} is zero"), word.letter, word.value),
                  NC_("core", "1 is used; write a factor other than zero")};
    });
    return 1;
  }
  return factor;
}

void Coordinates::scale(std::uint32_t column) {
  constexpr std::string_view factor_letters = "IJK";
  Vec3 factors = Vec3::Ones();
  if (words_.has_any(factor_letters)) {
    for (int axis = 0; axis < 3; ++axis) {
      const char letter = factor_letters[static_cast<std::size_t>(axis)];
      factors[axis] = words_.has(letter) ? scale_factor(words_[letter]) : 1;
    }
  } else if (!lacks("scale-factor", 'P', 510, column,
                    NC_("core", "the path is shown without it; write P with the factor"))) {
    factors = Vec3::Constant(scale_factor(words_['P']));
  }
  const Vec3 here = frames_.rotated().to_programmed(path().shown_position());
  frames_.scale(targets_.axes(here), factors);
}

void Coordinates::mirror(bool on) {
  const bool all = !on && !words_.has_any(axis_letters);
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = axis_letters[static_cast<std::size_t>(axis)];
    if (on && words_.has(letter)) {
      frames_.mirror(axis, modal_.to_mm(words_[letter].value));
    } else if (!on && (all || words_.has(letter))) {
      frames_.end_mirror(axis);
    }
  }
}

}  // namespace feedscope::iso
