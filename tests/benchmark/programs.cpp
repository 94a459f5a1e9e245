#include "tests/benchmark/programs.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace feedscope::benchmark {

std::string surface_program(std::size_t blocks) {
  constexpr std::size_t row_blocks = 500;
  constexpr double step = 0.2;          // mm
  constexpr double row_distance = 0.2;  // mm
  std::string text = "G17 G21 G90 G94\nG1 F6000\n";
  for (std::size_t i = 2; i < blocks; ++i) {
    const std::size_t row = i / row_blocks;
    const std::size_t along = row % 2 == 0 ? i % row_blocks : row_blocks - 1 - i % row_blocks;
    const double x = static_cast<double>(along) * step;
    const double y = static_cast<double>(row) * row_distance + 0.05 * std::sin(x);
    const double z = 8 * std::sin(x / 13) * std::cos(y / 17) + 0.3 * std::sin(x / 1.7);
    fmt::format_to(std::back_inserter(text), "X{:.3f} Y{:.3f} Z{:.3f}\n", x, y, z);
  }
  return text;
}

std::string arc_program(std::size_t blocks) {
  constexpr double radius = 4;     // mm
  constexpr double straight = 12;  // mm
  constexpr std::size_t row_waves = 500;
  std::string text = "G17 G21 G90 G94\nG1 F6000\n";
  double x = 0;
  for (std::size_t i = 2; i < blocks; ++i) {
    const std::size_t wave = i / 2 - 1;
    const bool upwards = wave % 2 == 0;
    if (i % 2 == 0) {
      fmt::format_to(std::back_inserter(text), "G1 Y{:.3f}\n", upwards ? straight : 0.0);
      continue;
    }
    const bool rightwards = wave / row_waves % 2 == 0;
    const double offset = rightwards ? radius : -radius;
    x += 2 * offset;
    fmt::format_to(std::back_inserter(text), "{} X{:.3f} I{:.3f} J0\n", upwards == rightwards ? "G2" : "G3",
                   x, offset);
  }
  return text;
}

}  // namespace feedscope::benchmark
