// The part of IsoReader that sets coordinates: offsets, shifts, rotation, scale, mirror image, reference
// points.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/program/iso/iso_reader.h"
#include "core/program/text/message.h"

namespace feedscope {

namespace {

constexpr std::string_view axis_letters = "XYZ";

bool is_compensation(int code) {
  return code >= 400 && code <= 421;
}

}  // namespace

std::string IsoReader::offset_name(int key) {
  constexpr int further = IsoCoordinates::further_work_offset(0);
  return key > further ? fmt::format("G54.1 P{}", key - further) : g_name(key);
}

void IsoReader::add_function(int code, std::uint32_t column) {
  if (words_.function_count < words_.functions.size()) {
    words_.functions[words_.function_count++] = {code, column};
  } else {
    report(Severity::error, "too-many-g", 0, column, [&] {
      return Text{fmt::format("{} is one G word too many in the block", g_name(code)),
                  "it is left out; write it in a block of its own"};
    });
  }
}

void IsoReader::run_functions() {
  if (words_.has('D') && !follows_linuxcnc(dialect_) && !words_.own_words) {
    state_.compensation.offset = static_cast<int>(words_['D'].value);
  }
  for (std::size_t i = 0; i < words_.function_count; ++i) {
    run_function(words_.functions[i].code, words_.functions[i].column);
  }
  if (path().is_compensated()) {
    renew_compensation();
  }
}

void IsoReader::run_function(int code, std::uint32_t column) {
  switch (code) {
    case 100:
      set_data(column);
      break;
    case 150:
    case 160:
      state_.polar = {.on = code == 160};
      break;
    case 280:
    case 300:
      go_to_reference(code, column);
      break;
    case 290:
      follows_linuxcnc(dialect_) ? report_levelling(column) : return_from_reference();
      break;
    case 500:
      coordinates_.end_scale();
      check_turning(column);
      break;
    case 501:
    case 511:
      mirror(code == 511);
      break;
    case 510:
      scale(column);
      break;
    case 520:
      follows_linuxcnc(dialect_) ? coordinates_.set_preset(programmed_axes(coordinates_.preset()))
                                 : coordinates_.set_local_shift(programmed_axes(coordinates_.local_shift()));
      break;
    case 680:
      rotate(column);
      break;
    case 682:
      tilt(column);
      break;
    case 700:
    case 710:
    case 720:
      drill_pattern(code, column);
      break;
    case 530:
      go_to_machine_coordinates(column);
      break;
    case 690:
      coordinates_.end_rotation();
      break;
    case 920:
      coordinates_.set_position(path().position(), programmed_axes(path().position()));
      break;
    case 921:
      coordinates_.forget_position();
      break;
    case 922:
      coordinates_.hold_position();
      break;
    case 923:
      coordinates_.restore_position();
      break;
    case 980:
    case 990:
      state_.to_initial_level = code == 980;
      break;
    default:
      is_compensation(code) ? compensate(code, column) : select_work_offset(code, column);
      return;
  }
  set_frame();
}

bool IsoReader::lacks(std::string_view code, char letter, int g, std::uint32_t column,
                      std::string_view effect) {
  if (words_.has(letter)) {
    return false;
  }
  report(Severity::error, code, letter, column, [&] {
    return Text{fmt::format("{} without {}", g_name(g), letter), std::string(effect)};
  });
  return true;
}

/// Of ReadOptions.
void IsoReader::take_given_offsets() {
  constexpr int numbered = 541;
  const WorkOffsets& offsets = options().offsets;
  for (const auto& [name, zero] : offsets.all()) {
    for (const int key : {540, 550, 560, 570, 580, 590, 591, 592, 593}) {
      if (WorkOffsets::key(g_name(key)) == name) {
        coordinates_.set_work_offset(key, {zero, 0});
      }
    }
    const std::string_view further = " P";
    const std::size_t at = name.find(further);
    const bool is_further =
        at != std::string::npos && (name.substr(0, at) == g_name(numbered) || name.substr(0, at) == "G154");
    if (is_further) {
      const int number = std::stoi(name.substr(at + further.size()));
      coordinates_.set_work_offset(IsoCoordinates::further_work_offset(number), {zero, 0});
    }
  }
  if (!offsets.empty()) {
    set_frame();
  }
}

void IsoReader::select_work_offset(int code, std::uint32_t column) {
  constexpr int numbered = 541;
  constexpr int numbered_of_haas = 1540;
  int key = code;
  if (code == numbered || code == numbered_of_haas) {
    const std::optional<int> further = offset_key(column, true);
    if (!further) {
      return;
    }
    key = *further;
  }
  const bool known = coordinates_.work_offset(key) != nullptr &&
                     coordinates_.work_offset(coordinates_.key_in_force()) != nullptr;
  if (path().has_moved() && state_.work_offset != 0 && state_.work_offset != key && !known) {
    report(Severity::warning, "work-offset", key, column, [&] {
      std::string option = offset_name(key);
      std::erase(option, ' ');
      return Text{fmt::format("{} follows {} on the way", offset_name(key), offset_name(state_.work_offset)),
                  fmt::format("offsets that are not given are assumed as zero, so parts of the path lie over "
                              "each other; give them as an import option, --offset {}=X,Y,Z",
                              option)};
    });
  }
  state_.work_offset = key;
  coordinates_.select_work_offset(key);
  path().use_work_offset(offset_name(key), coordinates_.zero_of(key));
  set_frame();
}

std::optional<int> IsoReader::offset_key(std::uint32_t column, bool further) {
  constexpr double most_further = 300;
  constexpr std::array keys{540, 550, 560, 570, 580, 590, 591, 592, 593};
  const double number = words_.has('P') ? words_['P'].value : 0;
  const double most = further ? most_further : static_cast<double>(keys.size());
  const double least = further ? 1 : 0;
  if (!(number >= least && number <= most && number == std::floor(number))) {
    report(Severity::error, "offset-number", 0, words_.has('P') ? words_['P'].column : column, [&] {
      return Text{fmt::format("P{} is no number of a work offset from {} to {}", number, least, most),
                  "the block has no effect on the path"};
    });
    return std::nullopt;
  }
  const int whole = static_cast<int>(number);
  if (further) {
    return IsoCoordinates::further_work_offset(whole);
  }
  return whole == 0 ? coordinates_.key_in_force() : keys[static_cast<std::size_t>(whole - 1)];
}

void IsoReader::set_data(std::uint32_t column) {
  const int kind = words_.has('L') ? static_cast<int>(std::clamp(words_['L'].value, -1.0, 1e6)) : 1;
  const bool fanuc = dialect_ == Dialect::fanuc;
  switch (kind) {
    case 1:
    case 10:
    case 11:
    case 12:
    case 13:
      set_tool_radius(kind, column);
      break;
    case 2:
      set_work_offset(false, column);
      break;
    case 20:
      fanuc ? set_work_offset(true, column) : preset_work_offset(column);
      break;
    default:
      report(Severity::warning, "unread-g", 100, column, [&] {
        return Text{fmt::format("G10 L{} (setting of data) is not read", kind),
                    "the path is shown without what it sets"};
      });
      break;
  }
}

void IsoReader::set_work_offset(bool further, std::uint32_t column) {
  const std::optional<int> key = offset_key(column, further);
  if (!key) {
    return;
  }
  const IsoCoordinates::WorkOffset* const known = coordinates_.work_offset(*key);
  IsoCoordinates::WorkOffset offset = known == nullptr ? IsoCoordinates::WorkOffset{} : *known;
  const bool adds = state_.incremental && dialect_ == Dialect::fanuc;
  offset.shift = adds ? Vec3(offset.shift + programmed_axes(Vec3::Zero())) : programmed_axes(offset.shift);
  if (words_.has('R')) {
    offset.angle = units::from_deg(words_['R'].value);
  }
  store_work_offset(*key, offset);
}

void IsoReader::store_work_offset(int key, const IsoCoordinates::WorkOffset& offset) {
  coordinates_.set_work_offset(key, offset);
  if (key == coordinates_.key_in_force()) {
    path().set_zero_in_use(offset.shift);
  }
}

void IsoReader::preset_work_offset(std::uint32_t column) {
  const std::optional<int> key = offset_key(column, false);
  if (!key) {
    return;
  }
  IsoCoordinates there = coordinates_;
  there.select_work_offset(*key);
  IsoCoordinates::WorkOffset offset = there.work_offset_in_force();
  const Vec3 shown = path().shown_position();
  const Vec3 preset = programmed_axes(there.frame().to_programmed(shown));
  offset.shift += shown - there.frame().to_shown(preset);
  store_work_offset(*key, offset);
}

void IsoReader::set_tool_radius(int kind, std::uint32_t column) {
  constexpr int radius_wear = 13;
  const bool length = (kind == 10 || kind == 11) && dialect_ == Dialect::fanuc;
  if (length || !words_.has('R')) {
    return;
  }
  if (!lacks("offset-number", 'P', 100, column, "the radius is left out; write P with the tool's number")) {
    const int number = static_cast<int>(words_['P'].value);
    const double radius = state_.to_mm(words_['R'].value);
    double& entry = tool_radii_[number];
    entry = kind == radius_wear ? entry + radius : radius;
  }
}

void IsoReader::rotate(std::uint32_t column) {
  if (lacks("rotation-angle", 'R', 680, column, "the path is shown without it; write R with the angle")) {
    return;
  }
  if (words_.has_any("IJK")) {
    rotate_in_space(column);
    return;
  }
  const double angle = units::from_deg(words_['R'].value);
  const Vec3 here = coordinates_.tilted().to_programmed(path().shown_position());
  coordinates_.rotate(state_.plane, programmed_axes(here),
                      state_.incremental ? coordinates_.angle() + angle : angle);
}

/// G68 X Y Z I J K R: about the axis (I, J, K) through X Y Z, counter-clockwise seen against it. A second one
/// turns what the first one has turned.
void IsoReader::rotate_in_space(std::uint32_t column) {
  Vec3 axis = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const char letter = "IJK"[i];
    axis[i] = words_.has(letter) ? words_[letter].value : 0;
  }
  if (axis.isZero()) {
    report(Severity::error, "rotation-angle", 1, column, [] {
      return Text{"G68 with I0 J0 K0 has no axis to turn about", "the path is shown without it"};
    });
    return;
  }
  const Vec3 here = coordinates_.rotated().to_programmed(path().shown_position());
  coordinates_.tilt(CoordinateFrame::rotation(axis.normalized(), units::from_deg(words_['R'].value),
                                              programmed_axes(here)));
  report_tilt(column);
}

/// G68.2 X Y Z I J K: the plane with its origin at X Y Z, instead of one before it. P0: turned by the Euler
/// angles I about Z, J about the X that this makes, K about the Z that this makes. P1 Q123: turned by I, J
/// and K about the X, Y and Z of the workpiece in the order of Q. Last by R about its own Z.
void IsoReader::tilt(std::uint32_t column) {
  coordinates_.end_rotation();
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
      return Text{
          fmt::format(
              "G68.2 P{} (tilted working plane by points, vectors or angles of projection) is not read",
              kind),
          "the path is shown without it"};
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
  coordinates_.tilt(CoordinateFrame::shift(programmed_axes(Vec3::Zero())) * turned *
                    CoordinateFrame::rotation(Vec3::UnitZ(), angle_of('R')));
  report_tilt(column);
}

void IsoReader::report_tilt(std::uint32_t column) {
  report(Severity::warning, "tilted-plane", 0, column, [] {
    return Text{"the working plane is tilted",
                "the path is shown on the workpiece; the axes of a machine that turns it move otherwise"};
  });
}

void IsoReader::report_levelling(std::uint32_t column) {
  report(Severity::info, "unread-g", 290, column, [] {
    return Text{"G29 (bed levelling of printers) is not read", "the path stays where it is"};
  });
}

/// G50 with S limits the spindle of a lathe.
void IsoReader::check_turning(std::uint32_t column) {
  if (!words_.has('S') || follows_linuxcnc(dialect_)) {
    return;
  }
  report(Severity::warning, "turning-program", 0, column, [] {
    return Text{"G50 with S is of a turning program",
                "turning is not read: X is taken as a radius, G98 and G99 as those of drilling cycles"};
  });
}

double IsoReader::scale_factor(const Word& word) {
  constexpr double least_in_thousandths = 50;
  const bool thousandths = !word.has_point && std::abs(word.value) >= least_in_thousandths;
  const double factor = thousandths ? word.value / 1000 : word.value;
  if (factor == 0) {
    report(Severity::error, "scale-factor", 0, word.column, [&] {
      return Text{fmt::format("scale factor {}{} is zero", word.letter, word.value),
                  "1 is taken; write a factor that is not zero"};
    });
    return 1;
  }
  return factor;
}

void IsoReader::scale(std::uint32_t column) {
  constexpr std::string_view factor_letters = "IJK";
  Vec3 factors = Vec3::Ones();
  if (words_.has_any(factor_letters)) {
    for (int axis = 0; axis < 3; ++axis) {
      const char letter = factor_letters[static_cast<std::size_t>(axis)];
      factors[axis] = words_.has(letter) ? scale_factor(words_[letter]) : 1;
    }
  } else if (!lacks("scale-factor", 'P', 510, column,
                    "the path is shown without it; write P with the factor")) {
    factors = Vec3::Constant(scale_factor(words_['P']));
  }
  const Vec3 here = coordinates_.rotated().to_programmed(path().shown_position());
  coordinates_.scale(programmed_axes(here), factors);
}

void IsoReader::mirror(bool on) {
  const bool all = !on && !words_.has_any(axis_letters);
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = axis_letters[static_cast<std::size_t>(axis)];
    if (on && words_.has(letter)) {
      coordinates_.mirror(axis, state_.to_mm(words_[letter].value));
    } else if (!on && (all || words_.has(letter))) {
      coordinates_.end_mirror(axis);
    }
  }
}

void IsoReader::go_to_reference(int code, std::uint32_t column) {
  if (words_.has_any(axis_letters)) {
    state_.intermediate_point = target_of_block();
    program_axes_of_block();
    if ((state_.intermediate_point - path().position()).norm() > same_point) {
      path().rapid(state_.intermediate_point);
    }
  }
  constexpr int second_reference = 2;
  AxisPlace place{AxisPlace::Kind::home, 0};
  if (code == 300) {
    const bool second = !words_.has('P') || words_['P'].value == second_reference;
    place.kind = second ? AxisPlace::Kind::tool_change : AxisPlace::Kind::unknown;
  }
  path().go_to_machine_place(axes_of_block(), {place, place, place});
  report_machine_move(g_name(code), "reference-point", column);
}

/// X, Y and Z that the block names; all of them if it names none.
std::array<bool, 3> IsoReader::axes_of_block() const {
  std::array<bool, 3> named{};
  for (std::size_t axis = 0; axis < named.size(); ++axis) {
    named[axis] = words_.has(axis_letters[axis]) || !words_.has_any("XYZ");
  }
  return named;
}

void IsoReader::go_to_machine_coordinates(std::uint32_t column) {
  if (!words_.has_any("XYZ")) {
    return;
  }
  const Vec3 target = programmed_axes(Vec3::Zero());
  AxisPlaces places;
  for (std::size_t axis = 0; axis < places.size(); ++axis) {
    places[axis] = {AxisPlace::Kind::machine, target[static_cast<Eigen::Index>(axis)]};
  }
  const bool at_feed = state_.motion == MotionMode::line && path().feed_mode() != FeedMode::inverse_time;
  path().go_to_machine_place(axes_of_block(), places, at_feed ? path().feed_rate() : 0);
  report_machine_move("G53", "machine-position", column);
}

void IsoReader::return_from_reference() {
  const Vec3 target = target_of_block();
  program_axes_of_block();
  if ((state_.intermediate_point - path().position()).norm() > same_point) {
    path().rapid(state_.intermediate_point);
  }
  path().rapid(target);
}

}  // namespace feedscope
