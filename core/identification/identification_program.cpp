#include "core/identification/identification_program.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/identification/section_times.h"
#include "core/program/dwell_lines.h"

namespace feedscope {
namespace {

using Eigen::Vector2d;

constexpr double pause = 0.25;               // [s]
constexpr std::size_t first_variable = 100;  // of a Fanuc: the time of section 1 is in the next one
constexpr std::array feed_shares{0.2, 0.5, 1.0};

void check(const IdentificationProgramRequest& request) {
  const auto within = [](std::string_view name, double value, double least, double most,
                         std::string_view unit) {
    if (!(value >= least && value <= most)) {
      throw InputError(message(NC_("core", "{} = {} {} is out of bounds; it must be from {} to {} {}"), name,
                               value, unit, least, most, unit));
    }
  };
  within("size", request.size, 20, 2000, "mm");
  within("feed-max", units::to_mm_min(request.feed_max), 100, 100'000, "mm/min");
}

/// Writes blocks for one control.
class MotionWriter {
 public:
  explicit MotionWriter(const IdentificationProgramRequest& request) : dialect_(request.dialect) {}

  void begin() {
    switch (dialect_) {
      case Dialect::heidenhain:
        line("BEGIN PGM IDENTIFY MM");
        break;
      case Dialect::fanuc:
        raw("%");
        raw("O0021 (IDENTIFY)");
        raw("G17 G21 G40 G49 G80 G90 G94");
        break;
      case Dialect::sinumerik:
        raw("G17 G71 G40 G90 G94 G64");
        break;
      case Dialect::iso:
      case Dialect::linuxcnc:
      case Dialect::grbl:
        raw("G17 G21 G90 G94");
        break;
      default:
        throw InputError(message(NC_("core",
                                     "there is no test program for dialect '{}'; there is one for iso, "
                                     "fanuc, linuxcnc, grbl, sinumerik and heidenhain"),
                                 info_of(dialect_).id));
    }
  }
  void end() {
    if (dialect_ == Dialect::fanuc) {  // M30 may clear the variables
      line("M0 (NOTE THE TIMES IN #101 AND ON)");
    }
    line("M30");
    if (is_klartext()) {
      line("END PGM IDENTIFY MM");
    } else if (dialect_ == Dialect::fanuc) {
      raw("%");
    }
  }
  std::uint32_t comment(const std::string& words) {
    line(is_klartext() || dialect_ == Dialect::sinumerik ? "; " + words : "(" + words + ")");
    return count_;
  }
  void rapid(const Vector2d& to) {
    line(is_klartext() ? "L " + place(to) + " R0 FMAX" : "G0 " + place(to));
    at_ = to;
  }
  void straight(const Vector2d& to, double feed) {
    line(is_klartext() ? fmt::format("L {} R0{}", place(to), feed_word(feed))
                       : fmt::format("G1 {}{}", place(to), feed_word(feed)));
    at_ = to;
  }
  void upright(double z, double feed) {
    const std::string word = feed > 0 ? feed_word(feed) : "";
    line(is_klartext() ? fmt::format("L Z{} R0{}", number(z), feed > 0 ? word : " FMAX")
                       : fmt::format("G{} Z{}{}", feed > 0 ? 1 : 0, number(z), word));
  }
  /// Writes a full circle, counter-clockwise, about `center`.
  void circle(const Vector2d& center, double feed) {
    if (is_klartext()) {
      line("CC " + place(center));
      line(fmt::format("C {} DR+{}", place(at_), feed_word(feed)));
      return;
    }
    const Vector2d offset = center - at_;
    line(fmt::format("G3 {} I{} J{}{}", place(at_), number(offset.x()), number(offset.y()), feed_word(feed)));
  }
  void wait() {
    for (const std::string& text : dwell_lines(dialect_, pause)) {
      line(text);
    }
    feed_ = 0;
  }
  /// The control's own statements stop the reading ahead before and after them.
  void start_time(std::size_t section) {
    if (dialect_ == Dialect::fanuc) {
      line("G53");
      line("#3001=0");
    } else if (dialect_ == Dialect::sinumerik) {
      line("STOPRE");
      line("$AC_TIMER[1]=0");
    }
    comment(section_mark(section, true));
  }
  void take_time(std::size_t section) {
    comment(section_mark(section, false));
    if (dialect_ == Dialect::fanuc) {
      line("G53");
      line(fmt::format("#{}=#3001", first_variable + section));
    } else if (dialect_ == Dialect::sinumerik) {
      line("STOPRE");
      line(fmt::format("R{}=$AC_TIMER[1]", section));
    }
  }
  std::string text() const { return text_; }

 private:
  bool is_klartext() const { return dialect_ == Dialect::heidenhain; }
  void raw(const std::string& words) {
    ++count_;
    text_ += words + "\n";
  }
  void line(const std::string& words) { raw(is_klartext() ? fmt::format("{} {}", count_, words) : words); }
  std::string number(double value) const {
    constexpr double unit = 1e4;
    const double rounded = std::round(value * unit) / unit + 0.0;
    return fmt::format("{}{:.4f}", is_klartext() && rounded >= 0 ? "+" : "", rounded);
  }
  std::string place(const Vector2d& to) const {
    return fmt::format("X{} Y{}", number(to.x()), number(to.y()));
  }
  std::string feed_word(double feed) {
    if (feed == feed_ && !is_klartext()) {
      return "";
    }
    feed_ = feed;
    return fmt::format(" F{:.0f}", units::to_mm_min(feed));
  }

  Dialect dialect_;
  std::string text_;
  std::uint32_t count_ = 0;
  Vector2d at_ = Vector2d::Zero();
  double feed_ = 0;  ///< in force [mm/s]; 0: none
};

class ProgramMaker {
 public:
  explicit ProgramMaker(const IdentificationProgramRequest& request)
      : size_(request.size), feed_max_(request.feed_max), writer_(request) {
    made_.height = std::min(30.0, size_ / 10);
  }

  IdentificationProgram make() {
    writer_.begin();
    writer_.comment("ZERO POINT: MIDDLE OF A FREE SQUARE, TOOL WHERE NOTHING IS BELOW OR AROUND IT");
    writer_.comment(
        fmt::format("KEEPS TO X AND Y +-{:.4g} MM, Z FROM 0 UP TO {:.4g} MM", size_ / 2, made_.height));
    writer_.rapid(Vector2d::Zero());  // at the present height, then down
    writer_.upright(0, 0);
    for (const int axis : {0, 1}) {
      single_moves(axis);
    }
    moves_of_z();
    ramps();
    corners();
    circles();
    short_blocks();
    writer_.rapid(Vector2d::Zero());
    writer_.end();
    made_.text = writer_.text();
    return std::move(made_);
  }

 private:
  void part(const std::string& title, const char* tells) {
    made_.parts.push_back({title, tells, writer_.comment(title)});
  }
  /// Writes motions between pauses, timed by the control.
  template <class Motions>
  void timed(const Motions& motions) {
    ++made_.sections;
    writer_.wait();
    writer_.start_time(made_.sections);
    motions();
    writer_.wait();
    writer_.take_time(made_.sections);
  }
  static Vector2d along(double angle) { return {std::cos(angle), std::sin(angle)}; }

  void single_moves(int axis) {
    part(fmt::format("SINGLE MOVES OF {}", axis == 0 ? 'X' : 'Y'),
         QT_TRANSLATE_NOOP("core", "Velocity, acceleration and jerk of the axis, from rest to rest."));
    const Vector2d direction = axis == 0 ? Vector2d::UnitX() : Vector2d::UnitY();
    writer_.rapid(-0.45 * size_ * direction);
    for (const double share : {0.01, 0.04, 0.15, 0.9}) {
      timed([&] { writer_.straight((share - 0.45) * size_ * direction, feed_max_); });
      timed([&] { writer_.straight(-0.45 * size_ * direction, feed_max_); });
    }
    timed([&] { writer_.rapid(0.45 * size_ * direction); });
    timed([&] { writer_.rapid(-0.45 * size_ * direction); });
    writer_.rapid(Vector2d::Zero());
  }
  void moves_of_z() {
    part("SINGLE MOVES OF Z", QT_TRANSLATE_NOOP("core", "Velocity, acceleration and jerk of Z."));
    for (const double share : {0.05, 0.25, 1.0}) {
      timed([&] { writer_.upright(share * made_.height, feed_max_); });
      timed([&] { writer_.upright(0, 0); });
    }
  }
  void ramps() {
    part("RAMPS BETWEEN FEEDS", QT_TRANSLATE_NOOP("core", "Acceleration and jerk along the path at speed."));
    for (const double angle : {0.0, std::numbers::pi / 4}) {
      writer_.rapid(-0.45 * size_ * along(angle));
      timed([&] {
        double share = -0.45;
        for (const double feed : {0.1, 0.4, 0.2, 1.0, 0.3}) {
          share += 0.18;
          writer_.straight(share * size_ * along(angle), feed * feed_max_);
        }
      });
    }
    writer_.rapid(Vector2d::Zero());
  }
  void corners() {
    part("CORNERS OF 10 TO 170 DEGREES",
         QT_TRANSLATE_NOOP("core",
                           "Speed through a corner over its angle: tolerance or corner rule, and how far "
                           "the control leaves the corner."));
    const double leg = 0.2 * size_;
    for (const double share : feed_shares) {
      for (const double degrees : {10.0, 20.0, 30.0, 45.0, 60.0, 90.0, 120.0, 150.0, 170.0}) {
        const double first = share == 0.5 ? std::numbers::pi / 2 : 0;
        const double second = first + units::from_deg(degrees);
        writer_.rapid(-leg * along(first));
        timed([&] {
          writer_.straight(Vector2d::Zero(), share * feed_max_);
          writer_.straight(leg * along(second), share * feed_max_);
        });
      }
    }
    writer_.rapid(Vector2d::Zero());
  }
  void circles() {
    part("CIRCLES", QT_TRANSLATE_NOOP("core", "Acceleration and jerk across the path, by radius."));
    for (const double radius : {0.005 * size_, 0.025 * size_, 0.1 * size_, 0.4 * size_}) {
      for (const double share : feed_shares) {
        writer_.rapid({radius, 0});
        timed([&] { writer_.circle(Vector2d::Zero(), share * feed_max_); });
      }
    }
  }
  void short_blocks() {
    part("SHORT BLOCKS", QT_TRANSLATE_NOOP("core", "Look-ahead, smoothing of points and time by block."));
    constexpr int blocks = 120;
    const double step = 0.004 * size_;
    for (const double share : feed_shares) {
      const double begin = -0.5 * blocks * step;
      writer_.rapid({begin, 0});
      timed([&] {
        for (int i = 1; i <= blocks; ++i) {
          const double x = begin + i * step;
          writer_.straight({x, 0.02 * size_ * std::sin(2 * std::numbers::pi * i / 40.0)}, share * feed_max_);
        }
      });
    }
  }

  double size_;
  double feed_max_;
  MotionWriter writer_;
  IdentificationProgram made_;
};

}  // namespace

IdentificationProgram identification_program(const IdentificationProgramRequest& request) {
  check(request);
  return ProgramMaker(request).make();
}

}  // namespace feedscope
