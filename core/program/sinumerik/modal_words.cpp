// The part of SinumerikReader that keeps what stays in force: G words, functions, feed and frames.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/program/sinumerik/names.h"
#include "core/program/sinumerik/sinumerik_reader.h"
#include "core/program/text/message.h"

namespace feedscope {

using namespace sinumerik;

void SinumerikReader::apply(const Function& function, std::uint32_t column) {
  if (function.group != Group::none) {
    check_group(function, column);
  }
  if (!function.subject.empty()) {
    report(function.severity, "unread-function", kind_of(function.name), column, [&] {
      return Text{fmt::format("{} ({}) is not read", function.name, function.subject),
                  std::string(function.effect)};
    });
  }
  apply_action(function);
  if (function.group == Group::compensation) {
    compensation_column_ = column;
  }
  if (function.group == Group::own_block) {
    own_block_ = &function;
    own_column_ = column;
  }
}

void SinumerikReader::check_group(const Function& function, std::uint32_t column) {
  const Function*& present = groups_[static_cast<std::size_t>(function.group)];
  if (present != nullptr && present != &function) {
    report(Severity::error, "conflicting-g", kind_of(function.name), column, [&] {
      return Text{fmt::format("{} and {} exclude each other in one block", present->name, function.name),
                  fmt::format("{} counts; remove the other", function.name)};
    });
  }
  present = &function;
}

void SinumerikReader::apply_action(const Function& function) {
  switch (function.action) {
    case Action::rapid:
    case Action::line:
    case Action::arc_cw:
    case Action::arc_ccw:
    case Action::arc_through:
    case Action::arc_tangent:
    case Action::spline:
    case Action::polynomial:
    case Action::thread:
    case Action::unread_motion:
      modal_.motion = &function;
      break;
    case Action::plane_xy:
      set_plane(Plane::xy);
      break;
    case Action::plane_zx:
      set_plane(Plane::zx);
      break;
    case Action::plane_yz:
      set_plane(Plane::yz);
      break;
    case Action::inch:
    case Action::metric:
    case Action::inch_all:
    case Action::metric_all:
      modal_.inch = function.action == Action::inch || function.action == Action::inch_all;
      modal_.inch_feed = modal_.inch;
      if (function.action == Action::inch || function.action == Action::metric) {
        modal_.inch_feed = first_unit() == LengthUnit::inch;  // feeds stay in the control's basic system
      }
      say_unit(modal_.inch ? LengthUnit::inch : LengthUnit::mm);
      break;
    case Action::absolute:
    case Action::incremental:
      modal_.incremental = function.action == Action::incremental;
      break;
    case Action::feed_per_minute:
      modal_.surface_speed = function.name.starts_with("G96");
      path().set_feed_mode(FeedMode::per_minute);
      break;
    case Action::feed_inverse_time:
      modal_.surface_speed = false;
      path().set_feed_mode(FeedMode::inverse_time);
      break;
    case Action::feed_per_revolution:
      modal_.surface_speed = function.name.starts_with("G96");
      path().set_feed_mode(FeedMode::per_revolution);
      break;
    case Action::corner_arc:
    case Action::corner_lines:
      modal_.corner_lines = function.action == Action::corner_lines;
      break;
    case Action::diameters:
    case Action::diameters_if_absolute:
    case Action::radii:
      modal_.diameters = function.action;
      break;
    case Action::machine_axes:
      machine_axes_ = true;
      machine_word_ = function.name;
      break;
    case Action::exact_stop_once:
      exact_stop_ = true;
      break;
    case Action::path_control:
      path_words_.apply(function.name);
      applied_ = Applied::none;
      break;
    case Action::spline_end:
      spline_.set_end(function.name);
      break;
    default:
      break;
  }
  oriented_ = (oriented_ || function.name == "TRAORI") && function.name != "TRAFOOF";
}

void SinumerikReader::set_plane(Plane plane) {
  if (plane != modal_.plane) {
    modal_.polar.angle.reset();
  }
  modal_.plane = plane;
}

double SinumerikReader::to_mm(double value) const {
  return modal_.inch ? units::from_inch(value) : value;
}

double SinumerikReader::feed_of(double value) const {
  const double length = modal_.inch_feed ? units::from_inch(value) : value;
  switch (path().feed_mode()) {
    case FeedMode::per_minute:
      return units::from_mm_min(length);
    case FeedMode::inverse_time:
      return value / 60;
    case FeedMode::per_revolution:
    case FeedMode::per_tooth:
      break;
  }
  return length;
}

void SinumerikReader::apply_feed() {
  // In G4 they are times, in G25 and G26 limits.
  const bool own = own_block_ != nullptr &&
                   (own_block_->action == Action::dwell || own_block_->action == Action::own_words);
  if (own) {
    return;
  }
  if (words_.has('S') && words_['S'].value >= 0 && !modal_.surface_speed) {
    path().set_spindle_speed(words_['S'].value / 60);
  }
  if (!words_.has('F')) {
    return;
  }
  const BlockWords::Value& word = words_['F'];
  if (!(word.value > 0)) {
    report(Severity::error, "feed-value", 0, word.column, [&] {
      return Text{fmt::format("feed F{} is not above zero", word.value),
                  path().feed() > 0 ? "the last valid feed stays in force; write a feed above zero"
                                    : "feed moves run as fast as the axes allow; write a feed above zero"};
    });
    return;
  }
  path().set_feed(feed_of(word.value));
}

void SinumerikReader::set_frame() {
  constexpr double most = 1e12;
  const CoordinateFrame frame = frames_.frame();
  const auto within = [](const Vec3& point) { return point.allFinite() && point.norm() < most; };
  if (within(frame.to_shown(Vec3::Ones())) && within(frame.to_programmed(Vec3::Ones()))) {
    keep_coordinates();
    path().set_frame(frame);
    return;
  }
  report(Severity::error, "frame-range", 0, own_column_, [] {
    return Text{"the frames together shift or scale beyond all measure",
                "all of them are taken back; check the additive ones in loops"};
  });
  frames_ = {};
  path().set_frame({});
}

void SinumerikReader::keep_coordinates() {
  for (int axis = 0; axis < 3; ++axis) {
    std::optional<double>& kept = kept_coordinates_[static_cast<std::size_t>(axis)];
    kept = kept.value_or(path().position()[axis]);
  }
}

Vec3 SinumerikReader::frame_values(double missing) const {
  Vec3 values = Vec3::Constant(missing);
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = axis_names[static_cast<std::size_t>(axis)];
    if (words_.has(letter)) {
      values[axis] = words_[letter].value;
    }
  }
  return values;
}

Vec3 SinumerikReader::frame_angles() const {
  Vec3 angles = frame_values(0);
  if (words_.has(Address::rpl)) {
    angles[normal_axis(modal_.plane)] = words_[Address::rpl].value;
  }
  return angles * (units::pi / 180);
}

void SinumerikReader::apply_frame() {
  const Function* const motion = groups_[static_cast<std::size_t>(Group::motion)];
  if (motion != nullptr && own_block_->action != Action::dwell &&
      own_block_->action != Action::machine_axes) {
    report(Severity::error, "conflicting-g", kind_of(own_block_->name), own_column_, [&] {
      return Text{fmt::format("{} and {} exclude each other in one block", motion->name, own_block_->name),
                  "the coordinates are those of the latter and nothing moves; write a block for each"};
    });
  }
  const auto shift = [this]() -> Vec3 { return frame_values(0) * to_mm(1); };
  const auto factors = [this](bool mirror) -> CoordinateFrame {
    Vec3 all = mirror ? Vec3::Ones() : frame_values(1);
    for (int axis = 0; mirror && axis < 3; ++axis) {
      all[axis] = words_.has(axis_names[static_cast<std::size_t>(axis)]) ? -1 : 1;
    }
    if ((all.array() == 0).any()) {
      report(Severity::error, "scale-factor", 0, own_column_, [] {
        return Text{"a scale factor is zero", "it is left out; write a factor other than zero"};
      });
      all = (all.array() == 0).select(1, all);
    }
    return CoordinateFrame::scale(all);
  };
  switch (own_block_->action) {
    case Action::dwell:
      dwell();
      return;
    case Action::machine_axes:
      move_machine_axes();
      return;
    case Action::pole_from_position:
    case Action::pole_from_zero:
    case Action::pole_from_pole:
      apply_pole();
      return;
    case Action::shift:
      frames_.replace(CoordinateFrame::shift(shift()));
      break;
    case Action::shift_more:
      frames_.add(CoordinateFrame::shift(shift()));
      break;
    case Action::turn:
      frames_.replace(turned_about(frame_angles()));
      break;
    case Action::turn_more:
      frames_.add(turned_about(frame_angles()));
      break;
    case Action::scale:
      frames_.replace(factors(false));
      break;
    case Action::scale_more:
      frames_.add(factors(false));
      break;
    case Action::mirror:
      frames_.replace(factors(true));
      break;
    case Action::mirror_more:
      frames_.add(factors(true));
      break;
    case Action::coarse_shift:
    case Action::fine_shift:
      for (int axis = 0; axis < 3; ++axis) {
        const char letter = axis_names[static_cast<std::size_t>(axis)];
        if (words_.has(letter) && own_block_->action == Action::coarse_shift) {
          frames_.set_coarse(axis, to_mm(words_[letter].value));
        } else if (words_.has(letter)) {
          frames_.set_fine(axis, to_mm(words_[letter].value));
        }
      }
      break;
    default:
      return;
  }
  set_frame();
}

void SinumerikReader::apply_pole() {
  Vec3 pole = own_block_->action == Action::pole_from_position ? path().position()
              : own_block_->action == Action::pole_from_pole   ? modal_.pole
                                                               : Vec3(Vec3::Zero());
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = axis_names[static_cast<std::size_t>(axis)];
    if (words_.has(letter)) {
      pole[axis] += to_mm(words_[letter].value);
    }
  }
  if (words_.has(Address::ap) && words_.has(Address::rp)) {
    const double angle = units::from_deg(words_[Address::ap].value);
    const double radius = to_mm(words_[Address::rp].value);
    pole[first_axis(modal_.plane)] += radius * std::cos(angle);
    pole[second_axis(modal_.plane)] += radius * std::sin(angle);
  }
  modal_.pole = pole;
  modal_.polar.angle.reset();
}

}  // namespace feedscope
