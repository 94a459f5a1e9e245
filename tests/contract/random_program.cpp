#include "tests/contract/random_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"

namespace feedscope::contract {
namespace {

constexpr double farthest = 1000;    ///< from the origin, along every axis [mm]
constexpr double min_radius = 1e-3;  ///< about that of arcs [mm]

std::size_t block_count(Random& random) {
  const double choice = random.unit();
  if (choice < 0.9) {
    return 1 + random.below(40);
  }
  return choice < 0.99 ? 40 + random.below(80) : 100 + random.below(300);
}

}  // namespace

RandomProgram::RandomProgram(Random& random)
    : random_(random),
      decimals_(random.chance(0.6) ? 3 : 3 + static_cast<int>(random.below(7))),
      arc_share_(std::array{0.0, 0.1, 0.5}[random.below(3)]),
      wildness_(random.chance(0.4) ? 0 : random.spread(1e-4, 1)),
      change_share_(random.chance(0.3) ? 0 : 0.1) {
  direction_ = random_direction();
  set_sizes();
}

std::vector<std::string> RandomProgram::lines() {
  const std::size_t count = block_count(random_);
  if (random_.chance(0.5)) {
    add_line("G0", at_ + 50 * random_direction());
  }
  while (lines_.size() < count) {
    add_block();
  }
  return lines_;
}

void RandomProgram::set_sizes() {
  const double choice = random_.unit();
  size_ = choice < 0.75   ? random_.spread(1e-2, 100)
          : choice < 0.92 ? random_.spread(1e-6, 1e-2)
                          : random_.spread(100, 1000);
  const double slowest = std::max(1.0, size_);  // a block lasts about a minute at most
  feed_ = random_.spread(slowest, 60000);
  feed_changed_ = true;
}

Vec3 RandomProgram::random_direction() {
  const Vec3 any(random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1));
  switch (random_.below(4)) {
    case 0:
      return Vec3::Unit(static_cast<Eigen::Index>(random_.below(3))) * random_.sign();
    case 1:
      return any.normalized();
    default:
      return Vec3(any.x(), any.y(), 0).normalized();
  }
}

std::string RandomProgram::rounded(double value) const {
  return fmt::format("{:.{}f}", value, decimals_);
}

std::string RandomProgram::feed_word() {
  if (!feed_changed_) {
    return "";
  }
  feed_changed_ = false;
  return fmt::format(" F{:.3f}", feed_);
}

void RandomProgram::turn() {
  const double choice = random_.unit();
  if (choice < 0.08) {
    return;
  }
  if (choice < 0.11) {
    direction_ = -direction_;
  } else if (wildness_ == 0 || choice < 0.15) {
    direction_ = random_direction();
  } else {
    const double much = random_.chance(0.8) ? wildness_ : random_.spread(1e-7, 3);
    direction_ = (direction_ + much * random_direction()).normalized();
  }
}

void RandomProgram::add_line(const char* code, const Vec3& target) {
  std::string line = code;
  for (int j = 0; j < 3; ++j) {
    const std::string word = rounded(target[j]);
    if (std::stod(word) != at_[j]) {
      line += fmt::format(" {}{}", coordinate_names[static_cast<std::size_t>(j)], word);
      at_[j] = std::stod(word);
    }
  }
  lines_.push_back(line + (line.starts_with("G0") ? "" : feed_word()));
}

void RandomProgram::add_arc() {
  static constexpr std::array<Plane, 3> planes{{{17, 0, 1, 2}, {18, 2, 0, 1}, {19, 1, 2, 0}}};
  static constexpr const char* offsets = "IJK";
  const Plane& plane = planes[random_.chance(0.7) ? 0 : random_.below(3)];
  const double sense = random_.sign();
  double heading = std::atan2(direction_[plane.b], direction_[plane.a]);
  if (random_.chance(0.15)) {
    heading = random_.between(-units::pi, units::pi);
  }
  const double radius = std::max(size_, min_radius) * random_.spread(0.1, 3);
  const double from = heading - sense * units::pi / 2;  // of the start, seen from the centre
  const bool full = random_.chance(0.15);
  const double sweep = full ? 2 * units::pi : random_.between(0.05, 6.2);

  const std::string center_a = rounded(-radius * std::cos(from));
  const std::string center_b = rounded(-radius * std::sin(from));
  std::string line = fmt::format("G{} G{}", plane.code, sense > 0 ? 3 : 2);
  if (!full) {
    for (const auto& [axis, step] : {std::pair{plane.a, std::cos(from + sense * sweep) - std::cos(from)},
                                     std::pair{plane.b, std::sin(from + sense * sweep) - std::sin(from)}}) {
      const std::string word = rounded(at_[axis] + radius * step);
      line += fmt::format(" {}{}", coordinate_names[static_cast<std::size_t>(axis)], word);
      at_[axis] = std::stod(word);
    }
  }
  if (random_.chance(0.2)) {
    const std::string word = rounded(at_[plane.normal] + random_.sign() * radius * random_.spread(0.01, 2));
    line += fmt::format(" {}{}", coordinate_names[static_cast<std::size_t>(plane.normal)], word);
    at_[plane.normal] = std::stod(word);
  }
  line += fmt::format(" {}{} {}{}", offsets[plane.a], center_a, offsets[plane.b], center_b);
  if (random_.chance(0.05)) {
    line += fmt::format(" P{}", 2 + random_.below(3));
  }
  lines_.push_back(line + feed_word());
  const double end = heading + sense * sweep;
  direction_ = Vec3::Zero();
  direction_[plane.a] = std::cos(end);
  direction_[plane.b] = std::sin(end);
}

void RandomProgram::add_dwell() {
  lines_.push_back(fmt::format("G4 P{:.3f}", random_.spread(1e-3, 10)));
}

void RandomProgram::add_block() {
  if (random_.chance(change_share_)) {
    set_sizes();
  }
  if (at_.cwiseAbs().maxCoeff() > farthest) {
    direction_ = -at_.normalized();
  }
  const double choice = random_.unit();
  if (choice < 0.02) {
    add_dwell();
  } else if (choice < 0.06) {
    add_line("G0", at_ + size_ * random_direction());
  } else if (choice < 0.07) {
    add_line("G1", at_);
  } else if (choice < 0.07 + arc_share_) {
    add_arc();
  } else {
    turn();
    add_line("G1", at_ + direction_ * size_ * random_.between(0.2, 1.2));
  }
}

}  // namespace feedscope::contract
