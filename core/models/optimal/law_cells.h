#pragma once

#include <vector>

#include "core/models/optimal/acceleration_range.h"
#include "core/models/optimal/path_cells.h"
#include "core/trajectory/piece.h"

namespace feedscope {

/// A cell for AccelerationLaw.
struct LawCell {
  double length;            ///< [mm]
  double offset;            ///< from the start of its element [mm]
  SpeedBound ceiling;       ///< of x = v^2 [mm2/s2]
  double acceleration = 0;  ///< straight: the largest, in both directions [mm/s2]
  double share = 1;         ///< curved: share of the limits used by its ends
  std::uint32_t element;
  std::uint32_t place = 0;   ///< curved: of its beginning, followed by its middle and its end
  std::int32_t common = -1;  ///< curved: limits of its ends where they are lowered, index in LawCells
  bool straight;
  std::int8_t axis = -1;  ///< straight: sets `acceleration`
};

/// Motion through a cell: on a curve one piece of constant jerk, unless it is `steady`.
struct CellRun {
  double x = 0;      ///< at its end [mm2/s2]
  double begin = 0;  ///< acceleration along the path at its beginning [mm/s2]
  double jerk = 0;
  double time = 0;             ///< [s]
  double load = 0;             ///< largest share of a limit used on the way; 0 where that is certain
  bool may_be_faster = false;  ///< the axes would allow more, except for the cells after it
  bool steady = false;         ///< by Phases
};

/// Constant accelerations on both sides of a constant speed in a cell.
struct Phases {
  double ceiling;  ///< of x [mm2/s2]
  double gain;     ///< [mm/s2]
  double loss;     ///< [mm/s2]
};

/// The cells of a part of the path with the axes' limits on them. Cells, places of curves and lowered limits
/// are stored separately, so that passes over them stay in the cache.
class LawCells {
 public:
  /// `fineness` as in CellRule.
  LawCells(const AxisVectors& axes, int fineness);

  void clear() { drop_front(size()); }
  void add_element(const BlendedPath& path, std::uint32_t index);
  void drop_front(std::size_t count);
  std::size_t size() const { return cells_.size(); }
  bool empty() const { return cells_.empty(); }
  const LawCell& operator[](std::size_t i) const { return cells_[i]; }

  /// Largest x at the beginning of cell `i`, and at its end.
  double top_at_begin(std::size_t i) const;
  double top_at_end(std::size_t i) const;
  /// Largest x at the beginning of cell `i` from which `next` or less can be reached at its end.
  double reach_back(std::size_t i, double next) const;
  /// The fastest motion from `x0` to at most `highest`.
  CellRun run(std::size_t i, double x0, double highest) const;
  /// Constant accelerations allowed on all of a curved cell; `gain` is 0 if they do not lead to `x1`.
  Phases phases(std::size_t i, double x0, double x1) const;

  /// Largest load on the curved cells [first, last) of one element, passed in `time` by one piece of constant
  /// jerk; infinite above `most` or if the piece turns back.
  double load_of(std::size_t first, std::size_t last, const LawPoint& from, double time, double most) const;

  /// Makes curved cell `i` keep at both ends the limits of all its places, and thus in between as well,
  /// because the limits are linear in x and u; where that is done already, lowers them by its `load`.
  void lower(std::size_t i, double load);

  /// Cause that keeps a cell from being faster when it begins with `x0`, and cause that bounds x at its end.
  Cause cause_at_begin(std::size_t i, double x0) const;
  AxisBound largest_at_end(std::size_t i) const;

 private:
  struct Place {
    AccelerationRange range;
    Vec3 t;  ///< tangent over the acceleration of the axes [s2/mm]
    Vec3 c;  ///< curvature vector over it [s2/mm2]
  };

  /// `ramp`: of rotary axes that turn along it; null for none.
  void add_straight(const PathCell& cell, const SpeedBound& programmed, const TurnRamp* ramp);
  void add_curved(const PathCell& cell, const SpeedBound& programmed, bool goes_on);
  void add_place(const PathPoint& at);
  SpeedBound ceiling_of(const SpeedBound& programmed, std::initializer_list<const PathPoint*> places) const;
  const Place& place(const LawCell& cell, int number) const { return places_[cell.place + number]; }
  double load(const LawCell& cell, double x0, const CellRun& run, bool begins_within) const;
  template <typename Range>
  static bool run_curved(const LawCell& cell, const Range& from, const Range& to, double x0, double highest,
                         CellRun& run);
  template <typename Use>
  auto with_ends(const LawCell& cell, const Use& use) const;

  const AxisVectors& axes_;
  Vec3 share_of_acceleration_;  ///< 1 / A_j; 0 for an axis that cannot move
  Vec3 share_of_velocity_;      ///< 1 / V_j
  CellRule rule_;
  std::vector<PathCell> path_cells_;  ///< of one element
  std::vector<LawCell> cells_;
  std::vector<Place> places_;
  std::vector<CommonRange> commons_;
};

}  // namespace feedscope
