#include "core/program/iso/language/modal_words.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/program/text/message.h"

namespace feedscope::iso {

namespace {

// Ten times their G numbers.
constexpr int constant_cutting_speed = 960;
constexpr int constant_spindle_speed = 970;

/// Ten times a G number; -1 for an impossible one.
int g_number(double value) {
  const double tenfold = std::round(value * 10);
  return value >= 0 && tenfold < 100000 && std::abs(tenfold - value * 10) < 1e-6 ? static_cast<int>(tenfold)
                                                                                 : -1;
}

}  // namespace

void ModalWords::apply_g(const Block& block, const Word& word) {
  const int number = g_number(word.value);
  const GCode* const code = find_g_code(number);
  if (code == nullptr) {
    words_.other_codes = true;
    report(Severity::error, "unknown-g", number, word.column, [&] {
      return Text{message(NC_("core", "{} is not a known G word"), in_quotes(block.text_of(word))),
                  NC_("core", "it is ignored; the control may run another path")};
    });
    return;
  }
  if (number == constant_cutting_speed || number == constant_spindle_speed) {
    path().spindle().set_surface_speed(number == constant_cutting_speed);
  }
  check_group(*code, word);
  words_.other_codes = words_.other_codes || code->group != GGroup::motion;
  // "G5.1 Q2 X0 Y0 Z0" of a Fanuc names the axes of a mode; without Q the code is LinuxCNC's spline.
  const bool chooses_mode = number == 51 && words_.has('Q') && !is_linuxcnc();
  if (code->needs_axes && (chooses_mode || !words_.has_any("XYZ"))) {
    words_.other_codes = true;
    words_.own_words = words_.own_words || chooses_mode;
    if (number == 50 || number == 51) {
      path_modes_.apply(*code);
    }
    return;
  }
  constexpr int tool_centre_point = 434;
  constexpr int tool_vectors = 435;
  constexpr int turn_tool_axis = 531;
  const bool followed = (number == tool_centre_point || number == tool_vectors || number == turn_tool_axis) &&
                        machining_.other_axes.turns();
  if (!code->subject.empty() && !followed) {
    report(code->severity, "unread-g", number, word.column, [&] {
      return Text{message(NC_("core", "{} ({}) is not supported"), g_name(number), code->subject),
                  code->effect};
    });
  }
  apply(*code, word);
  if (code->group == GGroup::tool_length) {
    modal_.tool_vectors = number == tool_vectors && machining_.other_axes.turns();
    modal_.tool_centre_point = number == tool_centre_point || modal_.tool_vectors;
  }
  if (number == turn_tool_axis) {
    machining_.other_axes.turn_tool(path().frame().turned(Vec3::UnitZ()));
  }
}

void ModalWords::check_group(const GCode& code, const Word& word) {
  if (code.group == GGroup::none) {
    return;
  }
  const GCode*& present = words_.groups[static_cast<std::size_t>(code.group)];
  if (present != nullptr && present != &code) {
    report(Severity::error, "conflicting-g", code.number, word.column, [&] {
      return Text{message(NC_("core", "{} and {} exclude each other in one block"), g_name(present->number),
                          g_name(code.number)),
                  message(NC_("core", "{} is used; remove the other"), g_name(code.number))};
    });
  }
  present = &code;
}

void ModalWords::apply(const GCode& code, const Word& word) {
  switch (code.action) {
    case GAction::accept:
    case GAction::report:
      break;
    case GAction::rapid:
      modal_.motion = MotionMode::rapid;
      break;
    case GAction::line:
      modal_.motion = MotionMode::line;
      break;
    case GAction::arc_cw:
      modal_.motion = MotionMode::arc_cw;
      break;
    case GAction::arc_ccw:
      modal_.motion = MotionMode::arc_ccw;
      break;
    case GAction::dwell:
      words_.dwell = word.column;
      break;
    case GAction::plane_xy:
      modal_.plane = Plane::xy;
      break;
    case GAction::plane_zx:
      modal_.plane = Plane::zx;
      break;
    case GAction::plane_yz:
      modal_.plane = Plane::yz;
      break;
    case GAction::inch:
    case GAction::metric:
      words_.changes_unit = modal_.inch != (code.action == GAction::inch);
      modal_.inch = code.action == GAction::inch;
      machining_.unit.set(modal_.inch ? LengthUnit::inch : LengthUnit::mm);
      break;
    case GAction::absolute:
      modal_.incremental = false;
      break;
    case GAction::incremental:
      modal_.incremental = true;
      break;
    case GAction::absolute_centers:
    case GAction::incremental_centers:
      modal_.absolute_centers = code.action == GAction::absolute_centers;
      names_centers_ = true;
      break;
    case GAction::feed_per_minute:
      path().set_feed_mode(FeedMode::per_minute);
      break;
    case GAction::other_feed:
      path().set_feed_mode(code.number == 930 ? FeedMode::inverse_time : FeedMode::per_revolution);
      break;
    case GAction::path_control:
      path_modes_.apply(code);
      break;
    case GAction::cancel_macro:
      calls_.cancel_modal_macro();
      break;
    case GAction::axis_function:
      words_.own_words = true;
      add_function(code.number, word.column);
      break;
    case GAction::function:
      add_function(code.number, word.column);
      break;
    case GAction::cycle:
      cycles_.begin(code, word);
      break;
    case GAction::spline:
      splines_.begin(code, word);
      break;
    case GAction::cancel_cycle:
      cycles_.cancel();
      break;
    case GAction::own_words:
      words_.own_words = true;
      break;
    case GAction::unread_motion:
      words_.other_codes = true;
      modal_.motion = MotionMode::unread;
      break;
  }
}

void ModalWords::add_function(int code, std::uint32_t column) {
  if (words_.function_count < words_.functions.size()) {
    words_.functions[words_.function_count++] = {code, column};
  } else {
    report(Severity::error, "too-many-g", 0, column, [&] {
      return Text{
          message(NC_("core", "{} exceeds the 8 G words of coordinates that a block can have"), g_name(code)),
          NC_("core", "it is skipped; write it in a block of its own")};
    });
  }
}

void ModalWords::apply_m(const Word& word) {
  words_.other_codes = true;
  if (word.value != std::floor(word.value) || word.value < 0 || word.value > 1000) {
    return;
  }
  switch (static_cast<int>(word.value)) {
    case 0:
    case 1:
    case 60:
      words_.stop = true;
      break;
    case 2:
    case 30:
      lines().end_program();
      break;
    case 3:
    case 4:
    case 13:
    case 14:
      machining_.tools.start_spindle();
      break;
    case 5:
    case 19:
      machining_.tools.stop_spindle();
      break;
    case 6:
      modal_.tool = words_.value_or('T', modal_.selected_tool);
      machining_.tools.change_to(fmt::format("{}", modal_.tool));
      break;
    case 70:
    case 71:
    case 72:
    case 73:
      if (is_linuxcnc()) {
        kept_modes_.run(static_cast<int>(word.value), word.column);
      }
      break;
    case 97:
      // Without P it ends the macro interrupts of a Fanuc.
      words_.flow = words_.has('P') ? &word : words_.flow;
      break;
    case 98:
    case 99:
      words_.flow = &word;
      break;
    case 117:
    case 118:
      // The words are a text for the operator of a printer.
      words_.own_words = words_.own_words || dialect() == Dialect::grbl;
      break;
    case 198:
      words_.flow = is_linuxcnc() ? words_.flow : &word;
      break;
    case 428:
    case 429:
    case 430:
      if (is_linuxcnc() && machining_.other_axes.turns()) {
        switch_kinematics(static_cast<int>(word.value), word.column);
      }
      break;
    default:
      break;
  }
}

/// As remapped in LinuxCNC's configurations of five-axis machines: M428 selects the machine's own kinematics,
/// in which X, Y and Z are the tip, M429 and M430 others.
void ModalWords::switch_kinematics(int number, std::uint32_t column) {
  modal_.tip_kinematics = number == 428;
  report(Severity::info, "rotary-feed", number, column, [&] {
    return Text{
        modal_.tip_kinematics
            ? NC_("core",
                  "M428 is read as in LinuxCNC's own five-axis configurations: X, Y and Z are the tool's tip")
            : message(NC_("core",
                          "M{} is read as in LinuxCNC's own five-axis configurations: X, Y and Z are those "
                          "of the machine"),
                      number),
        NC_("core", "a configuration may remap it otherwise")};
  });
}

/// F in mm a minute. LinuxCNC sets the feed before it changes the unit (Interp::execute_block); grbl and the
/// others read F in the unit of its block.
double ModalWords::length_of_feed(const Word& word) const {
  if (dialect() != Dialect::linuxcnc || !words_.changes_unit) {
    return modal_.to_mm(word.value);
  }
  const bool inch = !modal_.inch;
  report(Severity::warning, "feed-value", 1, word.column, [&] {
    return Text{
        message(NC_("core",
                    "F{} is in {}/min: LinuxCNC sets the feed before {} of the same block changes the unit"),
                word.value, inch ? Message(NC_("core", "inch")) : Message::as_written("mm"),
                std::string_view(inch ? "G21" : "G20")),
        message(NC_("core", "write {} in a block before it, or give --unit {} if the control starts so"),
                std::string_view(inch ? "G21" : "G20"), std::string_view(inch ? "mm" : "inch"))};
  });
  return inch ? units::from_inch(word.value) : word.value;
}

void ModalWords::apply_feed() {
  if (words_.has('S') && words_['S'].value >= 0) {
    path().set_spindle_speed(words_['S'].value / 60);
  }
  const bool is_time = words_.dwell > 0 && !words_.has_any("PXU");
  if (!words_.has('F') || is_time) {
    return;
  }
  const Word& word = words_['F'];
  if (!(word.value > 0)) {
    report(Severity::error, "feed-value", 0, word.column, [&] {
      return Text{message(NC_("core", "feed F{} is not above zero"), word.value),
                  path().feed() > 0
                      ? NC_("core", "the last valid feed stays in force; write a feed above zero")
                      : NC_("core", "feed moves run as fast as the axes allow; write a feed above zero")};
    });
    return;
  }
  switch (path().feed_mode()) {
    case FeedMode::per_minute:
      path().set_feed(units::from_mm_min(length_of_feed(word)));
      break;
    case FeedMode::inverse_time:
      path().set_feed(word.value / 60);
      break;
    case FeedMode::per_revolution:
    case FeedMode::per_tooth:
      path().set_feed(modal_.to_mm(word.value));
      break;
  }
}

void ModalWords::apply_tool() {
  if (!words_.has('T')) {
    return;
  }
  const double number = words_['T'].value;
  if (number > 0 && number != modal_.selected_tool) {
    machining_.tools.select(fmt::format("{}", number));
  }
  modal_.selected_tool = number;
}

}  // namespace feedscope::iso
