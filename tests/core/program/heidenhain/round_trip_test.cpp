#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "tests/core/program/heidenhain/read_heidenhain.h"
#include "tests/core/program/random_path.h"

namespace feedscope {
namespace {

enum class ArcStyle { center, radius, polar };

/// How a path is written down.
struct Style {
  bool din = false;
  bool incremental = false;
  bool inch = false;
  bool comma = false;
  bool numbered = false;
  ArcStyle arc = ArcStyle::center;
};

class Writer {
 public:
  explicit Writer(const Style& style) : style_(style), unit_(style.inch ? 25.4 : 1) {
    if (style.din) {
      block(fmt::format("%A G7{}", style.inch ? 0 : 1));
      block(style.incremental ? "G91" : "G90");
    } else {
      block(fmt::format("BEGIN PGM A {}", style.inch ? "INCH" : "MM"));
    }
  }

  void add(const Move& move) {
    const std::string feed = fmt::format(" F{}", style_.inch ? 6000 / 25.4 : 600);
    if (move.motion != Motion::arc) {
      const bool rapid = move.motion == Motion::rapid;
      if (style_.din) {
        block((rapid ? "G0" : "G1") + coordinates(move.target) + (rapid ? "" : feed));
      } else {
        block("L" + coordinates(move.target) + (rapid ? " FMAX" : feed));
      }
    } else {
      if (style_.din) {
        block(fmt::format("T1 G{} S100", 19 - move.axis));
        add_din_arc(move, feed);
      } else {
        block(fmt::format("TOOL CALL 1 {} S100", "XYZ"[move.axis]));
        add_arc(move, feed);
      }
    }
    position_ = move.target;
  }

  std::string text() const {
    std::string text = text_;
    if (style_.comma) {
      std::replace(text.begin(), text.end(), '.', ',');
    }
    return text;
  }

 private:
  void add_arc(const Move& move, const std::string& feed) {
    const std::string end = fmt::format(" DR{}", move.ccw ? '+' : '-') + feed;
    if (style_.arc == ArcStyle::radius) {
      block("CR" + coordinates(move.target) + fmt::format(" R{:+.9f}", radius_of(move)) + end);
      return;
    }
    std::string pole = "CC";
    for (int axis = 0; axis < 3; ++axis) {
      pole += axis == move.axis ? "" : fmt::format(" {}{:+.9f}", "XYZ"[axis], move.center[axis] / unit_);
    }
    block(pole);
    block((style_.arc == ArcStyle::center ? "C" + coordinates(move.target) : "CP IPA" + angle_of(move)) +
          end);
  }

  void add_din_arc(const Move& move, const std::string& feed) {
    if (style_.arc == ArcStyle::radius) {
      block(fmt::format("G{}{} R{:+.9f}", move.ccw ? 3 : 2, coordinates(move.target), radius_of(move)) +
            feed);
      return;
    }
    std::string pole;
    const Vec3 base = style_.incremental ? position_ : Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      pole +=
          axis == move.axis ? "" : fmt::format(" {}{:+.9f}", "IJK"[axis], (move.center - base)[axis] / unit_);
    }
    if (style_.arc == ArcStyle::center) {
      block(fmt::format("G{}", move.ccw ? 3 : 2) + coordinates(move.target) + pole + feed);
    } else {
      block("G91" + pole_from(move) + fmt::format(" G{} H", move.ccw ? 13 : 12) + angle_of(move) + feed);
      block(style_.incremental ? "G91" : "G90");
    }
  }

  std::string pole_from(const Move& move) const {
    std::string pole;
    for (int axis = 0; axis < 3; ++axis) {
      pole += axis == move.axis
                  ? ""
                  : fmt::format(" {}{:+.9f}", "IJK"[axis], (move.center - position_)[axis] / unit_);
    }
    return pole;
  }
  double radius_of(const Move& move) const {
    const double radius = (move.center - position_).norm() / unit_;
    return move.sweep < units::pi ? radius : -radius;
  }
  std::string angle_of(const Move& move) const {
    return fmt::format("{:+.12f} {}{}{:+.9f}", units::to_deg(move.ccw ? move.sweep : -move.sweep),
                       style_.din ? "" : "I", "XYZ"[move.axis],
                       (move.target[move.axis] - position_[move.axis]) / unit_);
  }
  std::string coordinates(const Vec3& target) const {
    const Vec3 words = (target - (style_.incremental ? position_ : Vec3::Zero())) / unit_;
    const char* const i = style_.incremental && !style_.din ? "I" : "";
    return fmt::format(" {0}X{1:+.9f} {0}Y{2:+.9f} {0}Z{3:+.9f}", i, words.x(), words.y(), words.z());
  }
  void block(const std::string& words) {
    if (style_.numbered && words.front() != '%') {
      text_ += fmt::format("{}{} ", style_.din ? "N" : "", ++number_);
    }
    text_ += words + (style_.din ? "*\n" : "\n");
  }

  Style style_;
  double unit_;
  int number_ = 0;
  std::string text_;
  Vec3 position_ = Vec3::Zero();
};

class HeidenhainRoundTrip : public testing::TestWithParam<bool> {};

TEST_P(HeidenhainRoundTrip, RandomPathsReadBackTheSameInEveryStyle) {
  std::mt19937 random(2026);
  for (int round = 0; round < 60; ++round) {
    const std::vector<Move> path = random_path(random);
    for (int bits = 0; bits < 48; ++bits) {
      const Style style{.din = GetParam(),
                        .incremental = (bits & 1) != 0,
                        .inch = (bits & 2) != 0,
                        .comma = (bits & 4) != 0,
                        .numbered = (bits & 8) != 0,
                        .arc = static_cast<ArcStyle>(bits / 16)};
      Writer writer(style);
      for (const Move& move : path) {
        writer.add(move);
      }
      const Dialect dialect = style.din ? Dialect::heidenhain_iso : Dialect::heidenhain;
      expect_same(path, read_clean_heidenhain(writer.text(), {.dialect = dialect}), 0);
      if (HasFailure()) {
        FAIL() << "round " << round << ", style " << bits << "\n" << writer.text();
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, HeidenhainRoundTrip, testing::Bool(),
                         [](const auto& p) { return p.param ? "din" : "conversational"; });

}  // namespace
}  // namespace feedscope
