#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace feedscope::heidenhain {

enum class FeedWord : std::uint8_t {
  none,
  value,           ///< F500
  rapid,           ///< FMAX, for this block
  of_tool_call,    ///< F AUTO
  per_tooth,       ///< FZ
  per_revolution,  ///< FU
};

enum class SideWord : std::uint8_t { none, off, left, right };

/// An optional coordinate or angle, absolute or as a difference.
struct OptionalWord {
  double value = 0;
  bool given = false;
  bool incremental = false;

  double from(double old) const { return !given ? old : incremental ? old + value : value; }
};

/// Words of one block that moves, in either of the two languages. Lengths in mm, angles in rad.
struct MotionWords {
  std::array<OptionalWord, 3> axes;
  std::array<OptionalWord, 6> other_axes;  ///< A B C U V W
  std::array<std::uint32_t, 6> other_columns{};
  bool has_other_axes = false;
  std::optional<Vec3> tool_vector;  ///< TX TY TZ of LN; missing ones are zero
  std::uint32_t vector_column = 0;
  OptionalWord polar_radius;
  OptionalWord polar_angle;
  std::optional<double> radius;        ///< R of an arc, rounding or approach
  std::optional<double> length;        ///< LEN
  std::optional<double> center_angle;  ///< CCA
  int turn = 0;                        ///< 1 DR+, -1 DR-, 0 not given
  FeedWord feed_word = FeedWord::none;
  double feed = 0;  ///< as written
  SideWord side = SideWord::none;
  std::optional<double> retract;   ///< M140 MB; infinite for MB MAX
  std::uint32_t first_column = 0;  ///< of the words for the target; 0: none
  std::uint32_t feed_column = 0;
  std::uint32_t side_column = 0;
  std::uint32_t m_column = 0;  ///< of the first M
  int m_count = 0;
  std::array<int, 12> m{};

  bool has_axes() const { return axes[0].given || axes[1].given || axes[2].given; }
  bool has_polar() const { return polar_radius.given || polar_angle.given; }
  std::uint8_t axis_bits() const {
    return static_cast<std::uint8_t>(axes[0].given | axes[1].given << 1 | axes[2].given << 2);
  }
  std::uint8_t absolute_bits() const {
    std::uint8_t bits = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      bits |= static_cast<std::uint8_t>(axes[axis].given && !axes[axis].incremental ? 1U << axis : 0U);
    }
    return bits;
  }
  std::uint8_t incremental_bits() const { return static_cast<std::uint8_t>(axis_bits() & ~absolute_bits()); }
  bool has_m(int number) const {
    for (int i = 0; i < m_count; ++i) {
      if (m[static_cast<std::size_t>(i)] == number) {
        return true;
      }
    }
    return false;
  }
};

}  // namespace feedscope::heidenhain
