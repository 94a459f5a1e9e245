#include "core/program/controls/klipper_reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "core/program/controls/klipper_limits.h"
#include "core/program/controls/klipper_line.h"
#include "core/program/path/arc_solver.h"

namespace feedscope {
namespace {

/// Reason why a line is not run; empty: it is run.
using Refusal = Message;

/// Known commands of printers that neither move nor wait for motion.
constexpr std::array<std::string_view, 26> without_motion{"G21",
                                                          "M104",
                                                          "M105",
                                                          "M106",
                                                          "M107",
                                                          "M109",
                                                          "M110",
                                                          "M114",
                                                          "M115",
                                                          "M117",
                                                          "M118",
                                                          "M140",
                                                          "M190",
                                                          "M73",
                                                          "M18",
                                                          "M84",
                                                          "M221",
                                                          "M900",
                                                          "ECHO",
                                                          "HELP",
                                                          "STATUS",
                                                          "GET_POSITION",
                                                          "SET_PRESSURE_ADVANCE",
                                                          "SET_GCODE_VARIABLE",
                                                          "M201",
                                                          "M203"};

class KlipperReader {
 public:
  KlipperReader(std::shared_ptr<const SourceText> source, const KlipperSettings& limits) : limits_(limits) {
    program_.source = std::move(source);
    program_.dialect = Dialect::grbl;
    program_.path_controls.emplace_back();
    program_.spindles.emplace_back();
  }

  ReadProgram read(const Progress* progress) {
    const SourceText& text = *program_.source;
    for (number_ = 1; number_ <= text.line_count(); ++number_) {
      stop_if_cancelled(progress);
      line_ = read_klipper_line(text.line(number_));
      if (line_.command.empty()) {
        continue;
      }
      ++program_.block_count;
      if (Refusal why = run(); !why.empty()) {
        refuse(why);
      }
    }
    return std::move(program_);
  }

 private:
  void refuse(const Refusal& why) {
    Diagnostic note;
    note.severity = Severity::info;
    note.line = number_;
    note.code = "refused";
    note.message = message(NC_("core", "Klipper rejects the line ({}); it is not run"), why);
    program_.diagnostics.push_back(std::move(note));
  }

  Refusal run() {
    const std::string& command = line_.command;
    if (command == "G0" || command == "G1") {
      return move();
    }
    if (command == "G2" || command == "G3") {
      return arc(command == "G2");
    }
    if (command == "G4") {
      return dwell();
    }
    if (command == "G17" || command == "G18" || command == "G19") {
      plane_ = command[2] - '7';
      return {};
    }
    if (command == "G20") {
      return NC_("core", "G20: inches are not supported");
    }
    if (command == "G90" || command == "G91") {
      incremental_ = command == "G91";
      return {};
    }
    if (command == "G92") {
      return set_origin();
    }
    if (command == "M220") {
      return set_speed_factor();
    }
    if (command == "M400") {
      wait(0);
      return {};
    }
    if (command == "M82" || command == "M83") {
      incremental_extruder_ = command == "M83";
      return {};
    }
    if (const std::optional<KlipperLimitChange> change = klipper_limit_change(line_)) {
      if (change->fault.empty()) {
        change->apply(limits_);
      }
      return change->fault;
    }
    const bool known = std::ranges::find(without_motion, command) != without_motion.end();
    return known ? Refusal() : message(NC_("core", "unknown command {}"), command);
  }

  /// Brings the feed of the line into force; returns its fault.
  Refusal take_feed() {
    if (!line_.has("F")) {
      return {};
    }
    const std::optional<double> feed = line_.number("F");
    if (!feed || !(*feed > 0)) {
      return NC_("core", "invalid speed F");
    }
    constexpr double seconds_a_minute = 60;
    speed_ = *feed * factor_ / seconds_a_minute;
    return {};
  }

  Refusal move() {
    Vec3 target = place_;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view letter = std::string_view("XYZ").substr(static_cast<std::size_t>(axis), 1);
      if (!line_.has(letter)) {
        continue;
      }
      const std::optional<double> value = line_.number(letter);
      if (!value) {
        return message(NC_("core", "{} has no number"), letter);
      }
      target[axis] = *value + (incremental_ ? place_[axis] : origin_[axis]);
    }
    if (Refusal why = take_feed(); !why.empty()) {
      return why;
    }
    const double extruded = extrude();
    if (extruded != 0 && (target - place_).norm() <= same_point) {
      wait(limits_.extrude_time(std::abs(extruded), speed_));
    } else {
      append(Motion::line, target);
    }
    return {};
  }

  /// Filament that the line extrudes [mm]; negative: it retracts.
  double extrude() {
    const std::optional<double> value = line_.number("E");
    const double before = extruder_;
    if (value) {
      extruder_ = *value + (incremental_ || incremental_extruder_ ? before : extruder_origin_);
    }
    return extruder_ - before;
  }

  MotionBlock& append(Motion motion, const Vec3& target) {
    MotionBlock& block = program_.motions.emplace_back();
    block.motion = motion;
    block.line = number_;
    block.target = target;
    block.feed = motion == Motion::dwell ? 0 : speed_;
    place_ = target;
    if (motion != Motion::dwell) {
      program_.bounds.add(target);
    }
    return block;
  }

  Refusal arc(bool clockwise) {
    static constexpr std::array<std::array<int, 3>, 3> planes{{{0, 1, 2}, {0, 2, 1}, {1, 2, 0}}};
    const auto [a, b, third] = planes[static_cast<std::size_t>(plane_)];
    if (incremental_) {
      return NC_("core", "arcs need absolute coordinates");
    }
    if (line_.has("R")) {
      return NC_("core", "arcs by radius are not supported");
    }
    Vec3 target = place_;
    std::array<double, 2> offset{};
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view letter = std::string_view("XYZ").substr(static_cast<std::size_t>(axis), 1);
      const std::optional<double> value = line_.number(letter);
      if (line_.has(letter) && !value) {
        return message(NC_("core", "{} has no number"), letter);
      }
      target[axis] = value ? *value + origin_[axis] : place_[axis];
    }
    for (std::size_t i = 0; i < 2; ++i) {
      offset[i] = line_.number(std::string_view("IJK").substr(static_cast<std::size_t>(i == 0 ? a : b), 1))
                      .value_or(0);
    }
    if (offset[0] == 0 && offset[1] == 0) {
      return NC_("core", "centre offsets of the plane are missing");
    }
    if (Refusal why = take_feed(); !why.empty()) {
      return why;
    }
    extrude();
    append_arc(target, offset, {a, b, third}, clockwise);
    return {};
  }

  void append_arc(const Vec3& target, const std::array<double, 2>& offset, const std::array<int, 3>& axes,
                  bool clockwise) {
    constexpr double full_turn = 2 * std::numbers::pi;
    const auto [a, b, third] = axes;
    const double x = -offset[0];
    const double y = -offset[1];
    Vec3 center = place_;
    center[a] -= x;
    center[b] -= y;
    const double end_x = target[a] - center[a];
    const double end_y = target[b] - center[b];
    double angle = std::atan2(x * end_y - y * end_x, x * end_x + y * end_y);
    angle += angle < 0 ? full_turn : 0;
    angle -= clockwise ? full_turn : 0;
    if (angle == 0 && target[a] == place_[a] && target[b] == place_[b]) {
      angle = full_turn;
    }
    const double radius = std::hypot(x, y);
    const bool closed = std::hypot(target[a] - place_[a], target[b] - place_[b]) <= same_point;
    if (std::abs(angle) * radius <= same_point || (closed && std::abs(angle) < full_turn / 2)) {
      append(Motion::line, target);
      return;
    }
    if (!closed && std::abs(std::hypot(end_x, end_y) - radius) > ArcTolerance().of(radius)) {
      append_chords(target, center, angle, axes);
      return;
    }
    ArcWords words;
    words.center = center;
    // Klipper's plane ZX has X first, so the sense is that of the axes X, Z.
    Vec3 axis = Vec3::Unit(a).cross(Vec3::Unit(b));
    words.axis = clockwise ? Vec3(-axis) : axis;
    words.turns = closed ? 1 : 0;
    MotionBlock& block = append(Motion::arc, target);
    block.arc = static_cast<std::int32_t>(program_.arcs.size());
    program_.arcs.push_back(words);
  }

  /// Appends an arc whose end is not on its circle, which Klipper does not check: about the centre by `angle`
  /// with the radius of the start; the last chord leads to the end.
  void append_chords(const Vec3& target, const Vec3& center, double angle, const std::array<int, 3>& axes) {
    const auto [a, b, third] = axes;
    const Vec3 spoke = place_ - center;
    const double rise = target[third] - place_[third];
    const double length = std::hypot(angle * std::hypot(spoke[a], spoke[b]), rise);
    const double chords = std::max(1.0, std::floor(length / limits_.arc_resolution));
    for (double i = 1; i < chords; ++i) {
      const double cosine = std::cos(angle * i / chords);
      const double sine = std::sin(angle * i / chords);
      Vec3 end = center;
      end[a] += spoke[a] * cosine - spoke[b] * sine;
      end[b] += spoke[a] * sine + spoke[b] * cosine;
      end[third] += rise * i / chords;
      append(Motion::line, end);
    }
    append(Motion::line, target);
  }

  Refusal dwell() {
    constexpr double milliseconds = 1000;
    const double time = line_.has("P") ? line_.number("P").value_or(-1) : 0;
    if (time < 0) {
      return NC_("core", "invalid time P");
    }
    wait(time / milliseconds);
    return {};
  }

  void wait(double seconds) { append(Motion::dwell, place_).dwell = seconds; }

  Refusal set_origin() {
    bool any = false;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view letter = std::string_view("XYZ").substr(static_cast<std::size_t>(axis), 1);
      if (line_.has(letter)) {
        const std::optional<double> value = line_.number(letter);
        if (!value) {
          return message(NC_("core", "{} has no number"), letter);
        }
        origin_[axis] = place_[axis] - *value;
        any = true;
      }
    }
    if (const std::optional<double> value = line_.number("E")) {
      extruder_origin_ = extruder_ - *value;
    } else if (!any) {
      origin_ = place_;
      extruder_origin_ = extruder_;
    }
    return {};
  }

  Refusal set_speed_factor() {
    constexpr double percent = 100;
    const double factor = line_.number("S").value_or(percent) / percent;
    if (!(factor > 0)) {
      return NC_("core", "invalid factor S");
    }
    speed_ *= factor / factor_;
    factor_ = factor;
    return {};
  }

  KlipperSettings limits_;
  ReadProgram program_;
  KlipperLine line_;
  std::uint32_t number_ = 0;
  Vec3 place_ = Vec3::Zero();   ///< [mm]
  Vec3 origin_ = Vec3::Zero();  ///< of coordinates, moved by G92 [mm]
  bool incremental_ = false;
  double extruder_ = 0;         ///< [mm]
  double extruder_origin_ = 0;  ///< of E, moved by G92 [mm]
  bool incremental_extruder_ = false;
  int plane_ = 0;
  double speed_ = 25;  ///< [mm/s]; before the first F
  double factor_ = 1;  ///< of M220
};

}  // namespace

ReadProgram read_as_klipper(std::shared_ptr<const SourceText> source, const KlipperSettings& limits,
                            const Progress* progress) {
  return KlipperReader(std::move(source), limits).read(progress);
}

}  // namespace feedscope
