#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace feedscope {

/// A circular arc or helix in grbl's own 32-bit numbers.
struct GrblArc {
  std::array<float, 3> start{};       ///< [mm]
  std::array<float, 3> end{};         ///< [mm]
  std::array<float, 2> to_center{};   ///< from the start, along the axes of the plane [mm]
  std::array<std::size_t, 3> axes{};  ///< the two of the plane, then the third
  float radius = 0;                   ///< [mm]
  bool clockwise = false;
};

/// An arc cut into chords within the arc tolerance (models/grbl/README.md, "Arcs").
class GrblChords {
 public:
  /// `tolerance`: of the chords [mm].
  GrblChords(const GrblArc& arc, float tolerance);

  /// Number of whole chords that fit; 0: the arc is one straight line.
  std::uint32_t count() const { return count_; }
  /// End of the next chord, except the last one, which ends with the arc; call it count() - 1 times [mm].
  std::array<float, 3> next();

 private:
  GrblArc arc_;
  std::array<float, 2> center_{};
  std::array<float, 2> spoke_{};  ///< from the centre to the current place
  std::array<float, 3> place_{};
  float step_angle_ = 0;
  float step_along_ = 0;
  float cosine_ = 1;
  float sine_ = 0;
  std::uint32_t count_ = 0;
  std::uint32_t done_ = 0;
  std::uint32_t since_exact_ = 0;
};

}  // namespace feedscope
