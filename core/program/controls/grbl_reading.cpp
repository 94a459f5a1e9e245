#include "core/program/controls/grbl_reading.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/program/controls/grbl_arc_words.h"
#include "core/program/controls/grbl_commands.h"

namespace feedscope {
namespace {

using Place = std::array<float, 3>;
using Fault = std::optional<GrblError>;
using Axes = GrblCommands::Axes;

char axis_letter(std::size_t axis) {
  return static_cast<char>('X' + static_cast<char>(axis));
}

/// The two axes of a plane and the third.
std::array<std::size_t, 3> axes_of(int plane) {
  switch (plane) {
    case 18:
      return {2, 0, 1};
    case 19:
      return {1, 2, 0};
    default:
      return {0, 1, 2};
  }
}

Vec3 as_vector(const Place& place) {
  return {static_cast<double>(place[0]), static_cast<double>(place[1]), static_cast<double>(place[2])};
}

class GrblReader {
 public:
  GrblReader(std::shared_ptr<const SourceText> source, float arc_tolerance) : arc_tolerance_(arc_tolerance) {
    program_.source = std::move(source);
    program_.dialect = Dialect::grbl;
    program_.path_controls.emplace_back();
    program_.spindles.emplace_back();
  }

  ReadProgram read(const Progress* progress) {
    const SourceText& text = *program_.source;
    GrblCommands commands;
    for (number_ = 1; number_ <= text.line_count(); ++number_) {
      stop_if_cancelled(progress);
      Fault fault = read_grbl_line(text.line(number_), line_);
      if (!fault && line_.empty()) {
        continue;
      }
      if (!fault) {
        fault = find_grbl_commands(line_, modes_, commands);
      }
      if (!fault) {
        fault = run(commands);
      }
      ++program_.block_count;
      if (fault) {
        refuse(*fault);
      }
    }
    return std::move(program_);
  }

 private:
  /// Resulting values of a line, before anything is changed.
  struct Values {
    float feed = 0;         ///< [mm/min] or [1/min]
    Place target{};         ///< of the axis words, in machine coordinates [mm]
    GrblArc arc;            ///< of G2 and G3
    float tool_length = 0;  ///< [mm]
    std::size_t set_offset = 0;
    Place offset{};  ///< of G10, or the shift of G92 [mm]
    bool moves = false;
  };

  void refuse(const GrblError& error) {
    Diagnostic note;
    note.severity = Severity::info;
    note.line = number_;
    note.code = "refused";
    note.message = error.about.empty()
                       ? message(NC_("core", "grbl rejects the line (error {}: {}); it is not run"),
                                 error.number, grbl_error_text(error.number))
                       : message(NC_("core", "grbl rejects the line (error {}: {}: {}); it is not run"),
                                 error.number, error.about, grbl_error_text(error.number));
    program_.diagnostics.push_back(std::move(note));
  }

  bool has_axis_words() const { return line_.has('X') || line_.has('Y') || line_.has('Z'); }

  float unit(const GrblModes& modes) const { return modes.inch ? 25.4F : 1.0F; }

  Place shift_of(const GrblModes& modes) const {
    Place sum{};
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] = offsets_[modes.offset][i] + shift_[i];
    }
    sum[2] += tool_length_;
    return sum;
  }

  /// Checks the line as a whole, then runs it.
  Fault run(const GrblCommands& asked) {
    Values values;
    used_ = "FNST";
    if (Fault fault = check_feed(asked, values)) {
      return fault;
    }
    if (line_.value('T').value_or(0) > 255) {
      return GrblError{38, Message::as_written("T")};
    }
    if (asked.dwell) {
      if (!line_.has('P')) {
        return GrblError{28, NC_("core", "P of G4")};
      }
      used_ += 'P';
    }
    if (Fault fault = check_axes(asked, values)) {
      return fault;
    }
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
      if (line_.has(letter) && used_.find(letter) == std::string::npos) {
        return GrblError{36, Message::as_written(std::string(1, letter))};
      }
    }
    execute(asked, values);
    return std::nullopt;
  }

  Fault check_feed(const GrblCommands& asked, Values& values) const {
    const std::optional<float>& word = line_.value('F');
    if (asked.modes.inverse_time) {
      const bool cuts = asked.axes == Axes::motion && asked.modes.motion != 80 && asked.modes.motion != 0;
      if (cuts && !word) {
        return GrblError{22, NC_("core", "F of G93")};
      }
      values.feed = word.value_or(0);
    } else if (word) {
      values.feed = *word * unit(asked.modes);
    } else {
      values.feed = modes_.inverse_time ? 0 : feed_;
    }
    return std::nullopt;
  }

  Fault check_axes(const GrblCommands& asked, Values& values) {
    const bool axis_words = has_axis_words();
    if (axis_words) {
      used_ += "XYZ";
    }
    find_target(asked, values);
    switch (asked.axes) {
      case Axes::none:
      case Axes::home:
      case Axes::second_home:
        break;
      case Axes::set_offset:
        return check_offset(asked, values);
      case Axes::shift:
        if (!axis_words) {
          return GrblError{26, Message::as_written("G92")};
        }
        for (std::size_t i = 0; i < 3; ++i) {
          const std::optional<float>& word = line_.value(axis_letter(i));
          const float length = i == 2 ? tool_length_ : 0;
          values.offset[i] =
              word ? place_[i] - offsets_[asked.modes.offset][i] - *word * unit(asked.modes) - length
                   : shift_[i];
        }
        break;
      case Axes::tool_length:
        if (!line_.has('Z') || line_.has('X') || line_.has('Y')) {
          return GrblError{37, Message::as_written("G43.1")};
        }
        values.tool_length = *line_.value('Z') * unit(asked.modes);
        break;
      case Axes::motion:
        return check_motion(asked, values);
    }
    return std::nullopt;
  }

  Fault check_offset(const GrblCommands& asked, Values& values) {
    if (!has_axis_words()) {
      return GrblError{26, Message::as_written("G10")};
    }
    if (!line_.has('L') || !line_.has('P')) {
      return GrblError{28, NC_("core", "L or P of G10")};
    }
    const auto p = static_cast<int>(*line_.value('P'));
    const auto l = static_cast<int>(*line_.value('L'));
    if (p < 0 || p > 6) {
      return GrblError{29, NC_("core", "P of G10")};
    }
    if (l != 2 && l != 20) {
      return GrblError{20, Message::as_written(fmt::format("G10 L{}", l))};
    }
    used_ += "LP";
    values.set_offset = p == 0 ? asked.modes.offset : static_cast<std::size_t>(p - 1);
    values.offset = offsets_[values.set_offset];
    for (std::size_t i = 0; i < 3; ++i) {
      if (const std::optional<float>& word = line_.value(axis_letter(i))) {
        const float value = *word * unit(asked.modes);
        const float length = i == 2 ? tool_length_ : 0;
        values.offset[i] = l == 2 ? value : place_[i] - shift_[i] - length - value;
      }
    }
    return std::nullopt;
  }

  void find_target(const GrblCommands& asked, Values& values) const {
    const Place shift = shift_of(asked.modes);
    values.target = place_;
    for (std::size_t i = 0; i < 3; ++i) {
      if (const std::optional<float>& word = line_.value(axis_letter(i))) {
        const float value = *word * unit(asked.modes);
        values.target[i] = asked.machine_place       ? value
                           : asked.modes.incremental ? value + place_[i]
                                                     : value + shift[i];
      }
    }
  }

  Fault check_motion(const GrblCommands& asked, Values& values) {
    const int motion = asked.modes.motion;
    if (asked.machine_place && motion != 0 && motion != 1) {
      return GrblError{30, Message::as_written("G53")};
    }
    if (motion == 80) {
      return GrblError{31, Message::as_written("G80")};
    }
    values.moves = has_axis_words();
    if (motion == 0) {
      return std::nullopt;
    }
    if (values.feed == 0) {
      return GrblError{22, Message::as_written("F")};
    }
    if (motion == 2 || motion == 3) {
      GrblArc& arc = values.arc;
      arc.axes = axes_of(asked.modes.plane);
      arc.start = place_;
      arc.end = values.target;
      arc.clockwise = motion == 2;
      return read_arc_words(line_, unit(asked.modes), arc, used_);
    }
    return motion == 38 && !values.moves ? Fault(GrblError{26, Message::as_written("G38")}) : std::nullopt;
  }

  // --- what the line does ---

  void execute(const GrblCommands& asked, const Values& values) {
    const std::optional<float>& speed = line_.value('S');
    const bool other_speed = speed && *speed != speed_;
    speed_ = speed.value_or(speed_);
    if (other_speed && modes_.spindle != 5) {
      wait(0);
    }
    const bool switches = asked.modes.spindle != modes_.spindle || asked.modes.coolant != modes_.coolant;
    if (switches) {
      wait(0);
    }
    if (asked.dwell) {
      constexpr float steps_a_second = 20;
      wait(std::ceil(steps_a_second * *line_.value('P')) / steps_a_second);
    }
    if (asked.no_tool_length || asked.axes == Axes::tool_length) {
      change(tool_length_, asked.no_tool_length ? 0 : values.tool_length);
    }
    if (asked.modes.offset != modes_.offset) {
      wait(0);
    }
    const bool was_inverse = modes_.inverse_time;
    modes_ = asked.modes;
    feed_ = modes_.inverse_time && !was_inverse ? 0 : feed_;
    if (!modes_.inverse_time) {
      feed_ = values.feed;
    }
    use_axes(asked, values);
    if (asked.stop) {
      wait(0);
    }
    if (asked.end) {
      wait(0);
      const bool inch = modes_.inch;
      modes_ = GrblModes();
      modes_.motion = 1;
      modes_.inch = inch;
    }
  }

  void use_axes(const GrblCommands& asked, const Values& values) {
    if (asked.save_home) {
      home_ = place_;
    }
    if (asked.save_second_home) {
      second_home_ = place_;
    }
    if (asked.clear_shift) {
      change(shift_, Place{});
    }
    switch (asked.axes) {
      case Axes::none:
      case Axes::tool_length:
        break;
      case Axes::set_offset:
        if (values.set_offset == modes_.offset) {
          change(offsets_[values.set_offset], values.offset);
        } else {
          offsets_[values.set_offset] = values.offset;
        }
        break;
      case Axes::shift:
        change(shift_, values.offset);
        break;
      case Axes::home:
        go_home(values.target, home_);
        break;
      case Axes::second_home:
        go_home(values.target, second_home_);
        break;
      case Axes::motion:
        if (values.moves) {
          move(values);
        }
    }
  }

  void go_home(const Place& by, const Place& home) {
    Place to = home;
    if (has_axis_words()) {
      move_straight(by, 0);
      for (std::size_t i = 0; i < 3; ++i) {
        to[i] = line_.has(axis_letter(i)) ? home[i] : by[i];
      }
    }
    move_straight(to, 0);
  }

  void move(const Values& values) {
    switch (modes_.motion) {
      case 0:
        move_straight(values.target, 0);
        break;
      case 2:
      case 3:
        move_round(values);
        break;
      case 38:
        wait(0);
        move_straight(values.target, feed_of(values, 0));
        wait(0);
        break;
      default: {
        float way = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          way += (values.target[i] - place_[i]) * (values.target[i] - place_[i]);
        }
        move_straight(values.target, feed_of(values, std::sqrt(way)));
      }
    }
  }

  /// Feed [mm/min]; `way`: factor for the feed of G93.
  float feed_of(const Values& values, float way) const {
    return modes_.inverse_time ? values.feed * way : values.feed;
  }

  MotionBlock& append(Motion motion) {
    MotionBlock& block = program_.motions.emplace_back();
    block.motion = motion;
    block.line = number_;
    block.target = as_vector(place_);
    return block;
  }

  /// `feed`: 0 of a rapid [mm/min].
  void move_straight(const Place& target, float feed) {
    place_ = target;
    MotionBlock& block = append(feed == 0 ? Motion::rapid : Motion::line);
    block.feed = static_cast<double>(feed) / 60;
    program_.bounds.add(block.target);
    moved_ = true;
  }

  void move_round(const Values& values) {
    const GrblArc& arc = values.arc;
    const float x = arc.end[arc.axes[0]] - arc.start[arc.axes[0]] - arc.to_center[0];
    const float y = arc.end[arc.axes[1]] - arc.start[arc.axes[1]] - arc.to_center[1];
    if (2 * arc.radius <= arc_tolerance_ || static_cast<double>(std::hypot(x, y)) <= same_point) {
      move_straight(values.target, values.feed);
      return;
    }
    float chords = 1;
    if (modes_.inverse_time) {
      GrblChords cut(arc, arc_tolerance_);
      chords = static_cast<float>(cut.count());
    }
    ArcWords words;
    words.axis = Vec3::Zero();
    words.axis[static_cast<Eigen::Index>(arc.axes[2])] = arc.clockwise ? -1 : 1;
    words.center = as_vector(arc.start);
    for (std::size_t i = 0; i < 2; ++i) {
      words.center[static_cast<Eigen::Index>(arc.axes[i])] += static_cast<double>(arc.to_center[i]);
    }
    constexpr float no_angle = 5e-7F;
    const float turn =
        std::atan2(arc.to_center[1] * x - arc.to_center[0] * y, -arc.to_center[0] * x - arc.to_center[1] * y);
    const bool closed = std::fabs(turn) <= no_angle;
    words.turns = closed ? 1 : 0;
    place_ = values.target;
    MotionBlock& block = append(Motion::arc);
    block.feed = static_cast<double>(values.feed * chords) / 60;
    block.arc = static_cast<std::int32_t>(program_.arcs.size());
    program_.arcs.push_back(words);
    program_.bounds.add(block.target);
    moved_ = true;
  }

  /// Ends all motion, then waits `seconds`.
  void wait(float seconds) {
    if (!moved_ && seconds == 0) {
      return;
    }
    append(Motion::dwell).dwell = static_cast<double>(seconds);
    moved_ = false;
  }

  template <typename T>
  void change(T& offset, const T& value) {
    if (offset != value) {
      wait(0);
      offset = value;
    }
  }

  float arc_tolerance_;
  ReadProgram program_;
  GrblLine line_;
  std::uint32_t number_ = 0;
  std::string used_;  ///< letters of the line used by a command

  GrblModes modes_;
  float feed_ = 0;  ///< [mm/min]
  float speed_ = 0;
  Place place_{};  ///< machine coordinates [mm]
  std::array<Place, 6> offsets_{};
  Place shift_{};  ///< G92
  float tool_length_ = 0;
  Place home_{};
  Place second_home_{};
  bool moved_ = false;  ///< since all motion last ended
};

}  // namespace

ReadProgram read_as_grbl(std::shared_ptr<const SourceText> source, float arc_tolerance,
                         const Progress* progress) {
  return GrblReader(std::move(source), arc_tolerance).read(progress);
}

}  // namespace feedscope
