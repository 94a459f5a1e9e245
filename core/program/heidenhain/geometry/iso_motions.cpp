#include "core/program/heidenhain/geometry/iso_motions.h"

#include <algorithm>
#include <array>

#include "core/base/units.h"

namespace feedscope::heidenhain {

namespace {

constexpr auto motion_codes = std::to_array<int>({0, 1, 2, 3, 5, 6, 7, 10, 11, 12, 13, 15, 16});

constexpr bool is_polar(int motion) {
  return motion >= 10 && motion <= 16;
}

}  // namespace

bool IsoMotions::set_motion(int code) {
  const bool moves = std::find(motion_codes.begin(), motion_codes.end(), code) != motion_codes.end();
  motion_ = moves ? code : motion_;
  return moves;
}

void IsoMotions::leave_by(double radius, const std::optional<ContourFeed>& feed) {
  leaving_radius_ = radius;
  leaving_feed_ = feed;
}

MotionWords IsoMotions::with_modal_rapid(MotionWords words) const {
  if (motion_ == 0 || motion_ == 10) {
    words.feed_word = FeedWord::rapid;
  }
  return words;
}

void IsoMotions::set_pole(const IsoBlock& block) {
  if (block.pole[0].given || block.pole[1].given || block.pole[2].given) {
    MotionWords pole;
    pole.axes = block.pole;
    targets_.set_pole(pole);
  }
}

void IsoMotions::set_radius(IsoBlock& block) const {
  MotionWords& words = block.motion;
  if (is_polar(motion_)) {
    if (block.radius) {
      words.polar_radius = {to_mm(*block.radius), true, incremental_};
    }
    if (block.angle) {
      words.polar_angle = {units::from_deg(*block.angle), true, incremental_};
    }
  } else if (block.radius) {
    words.radius = to_mm(*block.radius);
  }
}

void IsoMotions::run(IsoBlock& block) {
  MotionWords& words = block.motion;
  set_pole(block);
  set_radius(block);
  const bool circles = (block.has(2) || block.has(3) || block.has(5)) && !block.radius;
  if (!words.has_axes() && !words.has_polar() && !circles) {
    motions_.run_functions(words);
    return;
  }
  if (motion_ < 0) {
    report(Severity::warning, "motion-mode", 0, words.first_column, [] {
      return Text{NC_("core", "coordinates before the first of G0 to G16"),
                  NC_("core", "G0 is used; write the G word")};
    });
    motion_ = 0;
  }
  words = with_modal_rapid(words);
  words.turn = motion_ == 2 || motion_ == 12 ? -1 : motion_ == 3 || motion_ == 13 ? 1 : 0;
  words.first_column = words.first_column == 0 ? block.column : words.first_column;
  if (leaving_radius_) {
    words.radius = leaving_radius_;
    leaving_radius_.reset();
    approaches_.depart(ApproachKind::line_and_arc, is_polar(motion_), words, block.column, leaving_feed_);
    return;
  }
  run_path(block.radius.has_value(), words);
}

void IsoMotions::run_path(bool has_radius, const MotionWords& words) {
  switch (motion_) {
    case 2:
    case 3:
    case 5:
      motions_.run(has_radius ? PathKind::radius_arc : PathKind::center_arc, words);
      break;
    case 6:
      motions_.run(PathKind::tangent_arc, words);
      break;
    case 10:
    case 11:
      motions_.run(PathKind::polar_line, words);
      break;
    case 12:
    case 13:
    case 15:
      motions_.run(PathKind::polar_arc, words);
      break;
    case 16:
      motions_.run(PathKind::polar_tangent_arc, words);
      break;
    default:
      motions_.run(PathKind::line, words);
      break;
  }
}

}  // namespace feedscope::heidenhain
