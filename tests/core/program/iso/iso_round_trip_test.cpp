#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "tests/core/program/iso/iso_text.h"
#include "tests/core/program/random_path.h"

namespace feedscope {
namespace {

/// Writes numbers the long way round: as sums, through variables, as arguments.
class MacroWriter {
 public:
  MacroWriter(Dialect dialect, std::mt19937& random)
      : linuxcnc_(dialect == Dialect::linuxcnc), random_(random) {}

  std::string written(const std::vector<Move>& path) {
    text_ = "G90 G91.1 G21 F600\n";
    Vec3 position = Vec3::Zero();
    for (const Move& move : path) {
      write(move, position);
      position = move.target;
    }
    return text_ + (linuxcnc_ ? "M2\n" : "M30\n") + subprograms_;
  }

 private:
  std::string expression(double value) {
    const double part = std::round(std::uniform_real_distribution<double>(-50, 50)(random_));
    switch (random_() % 5) {
      case 0:
        return fmt::format("[{:.9f} + {}]", value - part, part);
      case 1:
        return fmt::format("[{:.9f}*2 - [{:.9f}]]", value, value);
      case 2:
        return fmt::format("[SQRT[{0:.9f}*{0:.9f}] * {1}]", std::abs(value), value < 0 ? -1 : 1);
      case 3: {
        const unsigned variable = 101 + ++variable_ % 50;
        text_ += fmt::format("#{} = {:.9f}\n", variable, value);
        return fmt::format("#{}", variable);
      }
      default:
        return fmt::format("{:.9f}", value);
    }
  }

  std::string words(std::string_view letters, const Vec3& values) {
    std::string words;
    for (int axis = 0; axis < 3; ++axis) {
      words += fmt::format(" {}{}", letters[static_cast<std::size_t>(axis)], expression(values[axis]));
    }
    return words;
  }

  void write(const Move& move, const Vec3& position) {
    std::string block;
    if (move.motion == Motion::arc) {
      constexpr const char* planes[] = {"G19", "G18", "G17"};
      block = fmt::format("{} G{}", planes[move.axis], move.ccw ? 3 : 2) + words("XYZ", move.target) +
              words("IJK", move.center - position);
    } else {
      block = (move.motion == Motion::rapid ? "G0" : "G1") + words("XYZ", move.target);
    }
    place(block + "\n");
  }

  /// Puts a block where it is run once: as it is, in a branch, a loop or a subprogram.
  void place(const std::string& block) {
    const unsigned label = ++label_;
    const unsigned way = random_() % 5;
    if (linuxcnc_) {
      const std::string forms[] = {
          block, fmt::format("o{0} if [#<_line> LT 0]\nG0 X999\no{0} else\n{1}o{0} endif\n", label, block),
          fmt::format("o{0} repeat [1]\n{1}o{0} endrepeat\n", label, block),
          fmt::format("o<part{0}> sub\n{1}o<part{0}> endsub\no<part{0}> call\n", label, block),
          fmt::format("o{0} do\n{1}o{0} while [0]\n", label, block)};
      text_ += forms[way];
      return;
    }
    const std::string forms[] = {block, fmt::format("IF [1 EQ 1] GOTO {0}\nG0 X999\nN{0}\n{1}", label, block),
                                 fmt::format("#500=0\nWHILE [#500 LT 1] DO1\n{}#500=#500+1\nEND1\n", block),
                                 fmt::format("M98 P{}\n", label), fmt::format("G65 P{}\n", label)};
    text_ += forms[way];
    if (way > 2) {
      subprograms_ += fmt::format("O{}\n{}M99\n", label, block);
    }
  }

  bool linuxcnc_;
  std::mt19937& random_;
  unsigned label_ = 1000;
  unsigned variable_ = 0;
  std::string text_;
  std::string subprograms_;
};

TEST(IsoRoundTrip, RandomPathsReadBackTheSameThroughVariablesBranchesLoopsAndCalls) {
  std::mt19937 random(2027);
  for (int round = 0; round < 300; ++round) {
    const std::vector<Move> path = random_path(random);
    for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc}) {
      const std::string text = MacroWriter(dialect, random).written(path);
      const ReadProgram program = read_clean_as(dialect, text);
      expect_same(path, program, 0);
      if (HasFailure()) {
        FAIL() << "round " << round << "\n" << text;
      }
    }
  }
}

}  // namespace
}  // namespace feedscope
