#include "core/analysis/circularity/test_program.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/program/dwell_lines.h"

namespace feedscope {
namespace {

using Eigen::Vector2d;

constexpr double pause = 0.5;  // [s]

void check(const CircularRequest& request) {
  constexpr double largest_radius = 1e5;
  constexpr double full_turn = 360;
  constexpr double rounding = 1e-9;
  if (!(request.radius >= 1e-3 && request.radius <= largest_radius)) {
    throw InputError(message(
        NC_("core", "radius = {} mm is out of bounds; it must be at least 0.001 mm and at most {} mm"),
        request.radius, largest_radius));
  }
  if (!(request.feed > 0)) {
    throw InputError(message(NC_("core", "feed = {} mm/min is out of bounds; it must be above 0 mm/min"),
                             units::to_mm_min(request.feed)));
  }
  if (!(request.sweep > 0 && units::to_deg(request.sweep) <= full_turn + rounding)) {
    throw InputError(
        message(NC_("core", "sweep = {} degrees is out of bounds; it must be above 0 and at most 360"),
                units::to_deg(request.sweep)));
  }
  if (!(request.entry_radius >= 0 && request.entry_radius <= request.radius)) {
    throw InputError(message(NC_("core",
                                 "entry radius = {} mm is out of bounds; it must be at least 0 mm and at "
                                 "most the radius of {} mm"),
                             request.entry_radius, request.radius));
  }
}

Vector2d at_angle(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Blocks of a test in the syntax of one control. Coordinates are those of the plane.
class BlockWriter {
 public:
  BlockWriter(const PlaneInfo& plane, Dialect dialect, int decimals)
      : plane_(plane), dialect_(dialect), decimals_(decimals) {}

  bool is_klartext() const { return dialect_ == Dialect::heidenhain; }
  std::uint32_t count() const { return count_; }
  std::string text() const { return text_; }

  /// Writes a line unchanged.
  void raw(const std::string& line) {
    ++count_;
    text_ += line + "\n";
  }
  /// Writes a block with the control's block number or end mark.
  void line(const std::string& block) {
    raw(is_klartext()                         ? fmt::format("{} {}", count_, block)
        : dialect_ == Dialect::heidenhain_iso ? fmt::format("N{} {} *", 10 * count_, block)
                                              : block);
  }
  void comment(const std::string& words) {
    const bool by_semicolon =
        is_klartext() || dialect_ == Dialect::heidenhain_iso || dialect_ == Dialect::sinumerik;
    line(by_semicolon ? "; " + words : "(" + words + ")");
  }
  void rapid(const Vector2d& to) {
    line(is_klartext() ? "L " + words(to, true) + " R0 FMAX" : code(0) + words(to, false));
  }
  void feed(double mm_min) { feed_ = mm_min; }
  void straight(const Vector2d& to) {
    line(is_klartext() ? fmt::format("L {} R0{}", words(to, true), take_feed())
                       : code(1) + words(to, false) + take_feed());
  }
  void arc(bool counter_clockwise, const Vector2d& from, const Vector2d& to, const Vector2d& center) {
    if (is_klartext()) {
      line("CC " + words(center, true));
      line(fmt::format("C {} {}{}", words(to, true), counter_clockwise ? "DR+" : "DR-", take_feed()));
      return;
    }
    if (dialect_ == Dialect::heidenhain_iso) {
      line(fmt::format("{} {}", center_word(plane_.first_center, center.x()),
                       center_word(plane_.second_center, center.y())));
      line(code(counter_clockwise ? 3 : 2) + words(to, false) + take_feed());
      return;
    }
    const Vector2d offset = center - from;
    line(fmt::format("{}{} {} {}{}", code(counter_clockwise ? 3 : 2), words(to, false),
                     center_word(plane_.first_center, offset.x()),
                     center_word(plane_.second_center, offset.y()), take_feed()));
  }
  void wait() {
    for (const std::string& text : dwell_lines(dialect_, pause)) {
      line(text);
    }
  }

 private:
  std::string number(double value) const {
    const double unit = std::pow(10, decimals_);
    return fmt::format("{:.{}f}", std::round(value * unit) / unit + 0.0, decimals_);
  }
  std::string words(const Vector2d& value, bool with_sign) const {
    const auto word = [&](char axis, double v) {
      return fmt::format("{}{}{}", axis, with_sign && !number(v).starts_with('-') ? "+" : "", number(v));
    };
    return word(plane_.first, value.x()) + " " + word(plane_.second, value.y());
  }
  std::string center_word(char word, double value) const { return fmt::format("{}{}", word, number(value)); }
  std::string code(int number) const {
    return dialect_ == Dialect::heidenhain_iso ? fmt::format("G{:02} ", number) : fmt::format("G{} ", number);
  }
  std::string take_feed() {
    const std::string text = feed_ > 0 ? fmt::format(" F{:.6g}", feed_) : "";
    feed_ = 0;
    return text;
  }

  const PlaneInfo& plane_;
  Dialect dialect_;
  int decimals_;
  std::string text_;
  std::uint32_t count_ = 0;
  double feed_ = 0;  ///< for the next feed block [mm/min]; 0: none
};

/// Writes one direction; returns the line of the circle.
std::uint32_t write_pass(BlockWriter& writer, const CircularRequest& request, bool counter_clockwise) {
  const double turn = counter_clockwise ? 1 : -1;
  const double end_angle = request.start + turn * request.sweep;
  const double quarter = turn * units::pi / 2;
  const double entry = request.entry_radius;
  const Vector2d center = Vector2d::Zero();
  const Vector2d start = at_angle(request.radius, request.start);
  const Vector2d end =
      request.sweep < 2 * units::pi * (1 - 1e-12) ? at_angle(request.radius, end_angle) : start;
  writer.rapid(entry > 0 ? center : start);
  writer.wait();
  writer.feed(units::to_mm_min(request.feed));
  if (entry > 0) {
    // A quarter circle about a point between centre and start, tangent to the circle.
    const Vector2d entry_center = at_angle(request.radius - entry, request.start);
    const Vector2d from = entry_center + at_angle(entry, request.start - quarter);
    writer.straight(from);
    writer.arc(counter_clockwise, from, start, entry_center);
  }
  writer.arc(counter_clockwise, start, end, center);
  const std::uint32_t line = writer.count();
  if (entry > 0) {
    const Vector2d exit_center = at_angle(request.radius - entry, end_angle);
    writer.arc(counter_clockwise, end, exit_center + at_angle(entry, end_angle + quarter), exit_center);
    writer.straight(center);
  }
  writer.wait();
  return line;
}

}  // namespace

SimulatedCircles simulated_circles(const CircularRequest& request) {
  check(request);
  constexpr int decimals = 9;
  const PlaneInfo& plane = info_of(request.plane);
  BlockWriter writer(plane, Dialect::iso, decimals);
  writer.line(fmt::format("{} G21 G90 G94", plane.code));
  SimulatedCircles circles;
  circles.lines = {write_pass(writer, request, true), write_pass(writer, request, false)};
  writer.line("M30");
  circles.text = writer.text();
  return circles;
}

std::string test_program(std::span<const CircularRequest> requests, Dialect dialect) {
  constexpr int decimals = 4;
  for (const CircularRequest& request : requests) {
    check(request);
  }
  const PlaneInfo& plane = info_of(requests.front().plane);
  BlockWriter writer(plane, dialect, decimals);
  switch (dialect) {
    case Dialect::heidenhain:
      writer.line("BEGIN PGM CIRCULAR MM");
      writer.comment(fmt::format("TOOL AXIS ACROSS {}: CALL A TOOL BEFORE", plane.name));
      break;
    case Dialect::heidenhain_iso:
      writer.raw("%CIRCULAR G71 *");
      writer.line(fmt::format("{} G90", plane.code));
      break;
    case Dialect::fanuc:
      writer.line("%");
      writer.line("O0230 (CIRCULAR TEST)");
      writer.line(fmt::format("{} G21 G40 G49 G80 G90 G94", plane.code));
      break;
    case Dialect::sinumerik:
      writer.line(fmt::format("{} G71 G40 G90 G94 G64", plane.code));
      break;
    default:
      writer.line(fmt::format("{} G21 G90 G94", plane.code));
  }
  writer.comment("CIRCULAR TEST ISO 230-4: ZERO POINT IN THE CENTRE, TOOL ABOVE THE PART");
  for (const CircularRequest& request : requests) {
    for (const bool counter_clockwise : {true, false}) {
      writer.comment(fmt::format("RADIUS {:.6g} MM, {:.6g} MM/MIN, {}", request.radius,
                                 units::to_mm_min(request.feed),
                                 counter_clockwise ? "COUNTER-CLOCKWISE" : "CLOCKWISE"));
      write_pass(writer, request, counter_clockwise);
    }
  }
  switch (dialect) {
    case Dialect::heidenhain:
      writer.line("M30");
      writer.line("END PGM CIRCULAR MM");
      break;
    case Dialect::heidenhain_iso:
      writer.raw("N99999999 %CIRCULAR G71 *");
      break;
    case Dialect::fanuc:
      writer.line("M30");
      writer.line("%");
      break;
    default:
      writer.line("M30");
  }
  return writer.text();
}

}  // namespace feedscope
