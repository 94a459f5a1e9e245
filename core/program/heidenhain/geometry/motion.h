#pragma once

#include <array>
#include <cstdint>

#include "core/program/heidenhain/language/m_functions.h"

namespace feedscope::heidenhain {

enum class PathKind : std::uint8_t {
  line,               ///< L, G0, G1
  center_arc,         ///< C: about the pole
  radius_arc,         ///< CR
  tangent_arc,        ///< CT, G6
  polar_line,         ///< LP, G10, G11
  polar_arc,          ///< CP, G12, G13: about the pole
  polar_tangent_arc,  ///< CTP, G16
};

/// A word of A B C U V W.
void set_other_axis(char letter, double value, bool incremental, std::uint32_t column, MotionWords& words);

/// Runs blocks that move: lines and arcs, corners between them, other axes, positions of the machine.
class Motions : private Part {
 public:
  /// All outlive it.
  Motions(Context& context, Feeds& feeds, Tools& tools, Targets& targets, MFunctions& m_functions)
      : Part(context), feeds_(feeds), tools_(tools), targets_(targets), m_functions_(m_functions) {}

  void run(PathKind kind, const MotionWords& words);
  /// A block of M functions, other axes and modes, perhaps a line.
  void run_functions(const MotionWords& words) { run(PathKind::line, words); }
  /// RND and CHF; `size` in mm. Throws ReadFault.
  void run_corner(bool rounding, double size, const MotionWords& words, std::uint32_t column);

  /// True if the last motion was a rapid.
  bool was_rapid() const { return was_rapid_; }
  void set_was_rapid(bool rapid) { was_rapid_ = rapid; }

 private:
  void add(PathKind kind, const MotionWords& words);
  void add_center_arc(ContourElement element, const MotionWords& words);
  void add_radius_arc(ContourElement element, const MotionWords& words);
  void add_tangent_arc(ContourElement element);
  void add_polar(PathKind kind, const MotionWords& words);
  /// Reports a word of the block that no motion of this kind has.
  void check_words(PathKind kind, const MotionWords& words) const;
  void orient_tool(const MotionWords& words);
  void follow_axis_functions(const MotionWords& words);
  void move_other_axes(const MotionWords& words);
  AxisBlock turning(bool rapid) const;
  int turn_of(const MotionWords& words);
  bool goes_to_machine_position(const MotionWords& words);

  Feeds& feeds_;
  Tools& tools_;
  Targets& targets_;
  MFunctions& m_functions_;
  bool was_rapid_ = false;
  int last_turn_ = 0;
  std::array<double, 6> other_places_{};  ///< of A B C U V W as written
};

}  // namespace feedscope::heidenhain
