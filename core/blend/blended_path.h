#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/blend/compaction.h"
#include "core/blend/corner.h"
#include "core/blend/executed_path.h"
#include "core/blend/fitted_course.h"

namespace feedscope {

/// `blend`: a cubic blend in a corner; `connecting_arc`: a circle arc in one; `filtered`: a segment as
/// smoothing filters draw it, whose course is known to the motion alone; `fitted`: the same as a curve by
/// path length, for a motion of its own; `curve`: a span of a smooth curve through several blocks.
enum class ElementKind : std::uint8_t { line, arc, blend, connecting_arc, dwell, filtered, fitted, curve };

/// One geometric piece of the path that the control executes.
struct PathElement {
  Vec3 start;                 ///< [mm]; of a filtered element as programmed
  Vec3 end;                   ///< [mm]
  double s = 0;               ///< path length at the start, from the path's beginning [mm]
  double length = 0;          ///< [mm]; 0 for a dwell
  std::uint32_t segment = 0;  ///< of the programmed path; for a blend the one that ends at its corner
  std::uint32_t index = 0;    ///< blends and connecting arcs: of the corner; filtered: of the motion;
                              ///< fitted and curves: of the first knot; lines: how many parts of the same
                              ///< line are before it
  ElementKind kind = ElementKind::line;
};

/// The course of one element, ready to be evaluated many times.
class ElementCurve {
 public:
  ElementKind kind = ElementKind::line;
  double length = 0;  ///< [mm]
  Vec3 start;         ///< [mm]
  Vec3 end;           ///< [mm]
  Vec3 direction;     ///< lines: unit; zero for a dwell; filtered: along the programmed chord
  Arc arc;            ///< arcs and connecting arcs
  CubicBlend blend;   ///< blends
  std::span<const CourseKnot> course;  ///< fitted, curves; of the path, which must outlive this
  std::optional<CourseSpan> span;      ///< curves

  /// Position and derivatives by path length at `s` from the element's start, clamped to it [mm]. For a
  /// filtered element the chord stands in; Trajectory::state_at_path follows the course itself.
  CurvePoint at(double s) const;
  bool is_arc() const { return kind == ElementKind::arc || kind == ElementKind::connecting_arc; }
};

/// The part of an element on one block of the program: from `q` [mm] along it to the next part.
struct ElementPart {
  std::uint32_t element = 0;
  std::uint32_t block = 0;
  double q = 0;  ///< 0 for the first part of an element [mm]
};

/// The executed geometry: programmed segments, shortened where corner blends are inserted. Keeps the
/// programmed path and of every element only what that does not say: 16 bytes an element, 12 more a corner.
class BlendedPath {
 public:
  BlendedPath() = default;
  /// `compacted`: what the control made of `programmed` before it went on, if it did.
  BlendedPath(std::shared_ptr<const Toolpath> programmed, std::shared_ptr<const CompactedPath> compacted);
  explicit BlendedPath(std::shared_ptr<const Toolpath> programmed)
      : BlendedPath(std::move(programmed), std::shared_ptr<const CompactedPath>()) {}
  /// `executed`: what the control runs in place of `programmed`; it may grow until its segments are added.
  BlendedPath(std::shared_ptr<const Toolpath> programmed, std::shared_ptr<const ExecutedPath> executed);

  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }
  double length() const { return length_; }  ///< [mm]
  ElementKind kind(std::size_t i) const { return entries_[i].kind; }
  std::uint32_t segment(std::size_t i) const { return entries_[i].block; }
  std::uint32_t index(std::size_t i) const { return entries_[i].index; }
  double s(std::size_t i) const { return i < size() ? entries_[i].s : length_; }
  double length(std::size_t i) const { return s(i + 1) - entries_[i].s; }
  /// Where line element `i` begins on its segment of base() [mm].
  double line_offset(std::size_t i) const;
  bool in_corner(std::size_t i) const {
    return kind(i) == ElementKind::blend || kind(i) == ElementKind::connecting_arc;
  }
  /// The same, or part of a corner that the control rounds in a way of its own.
  bool rounds_corner(std::size_t i) const {
    return in_corner(i) || (executed_ && executed_->rounds_corner(static_cast<std::uint32_t>(i)));
  }
  PathElement element(std::size_t i) const;
  ElementCurve curve(std::size_t i) const;
  /// Number of the element on which path length `s` lies, the earlier one at a border; 0 <= s <= length().
  std::size_t element_at(double s) const;

  /// The programmed path, never null but for an empty path.
  const std::shared_ptr<const Toolpath>& programmed() const { return programmed_; }
  /// What the elements run on: the executed or the compacted path where there is one.
  const Toolpath& base() const {
    return executed_ ? executed_->path : compacted_ ? compacted_->path : *programmed_;
  }
  bool is_executed() const { return executed_ != nullptr; }
  /// The segment of base() that element `i` runs on.
  std::size_t base_segment_of(std::size_t i) const {
    return executed_ ? entries_[i].index : base_segment(entries_[i].block);
  }
  /// The segment that gives line, feed and rapid of element `i`.
  const Segment& source_segment(std::size_t i) const {
    return executed_ ? executed_->path.segments[entries_[i].index] : programmed_->segments[entries_[i].block];
  }
  /// The segment of base() that programmed segment `block` became, or became a part of; without an executed
  /// path.
  std::size_t base_segment(std::uint32_t block) const;
  /// The first programmed segment of those that became segment `i` of base(), without an executed path.
  std::size_t first_block(std::size_t i) const { return compacted_ ? compacted_->first[i] : i; }
  /// How many they are.
  std::size_t blocks_of_base(std::size_t i) const { return first_block(i + 1) - first_block(i); }
  const std::shared_ptr<const CompactedPath>& compacted() const { return compacted_; }  ///< null: none

  /// Corners that the control rounds in a way of its own, in order of their elements.
  std::size_t rounded_count() const { return executed_ ? executed_->corners.size() : 0; }
  const RoundedCorner& rounded(std::size_t i) const { return executed_->corners[i]; }
  /// Corners in order of their elements.
  std::size_t corner_count() const { return corners_.size(); }
  std::uint32_t corner_element(std::size_t corner) const { return corners_[corner]; }
  double corner_transition(std::size_t corner) const { return transitions_[corner]; }  ///< T [mm]
  std::size_t curve_count() const { return curves_; }                                  ///< smooth curves
  /// How the corner was laid: its turn [rad], transition and distance of the corner point [mm].
  Corner corner(std::size_t corner) const;
  double turn(std::size_t corner) const;               ///< the same alone [rad]
  double min_radius(std::size_t corner) const;         ///< [mm]
  const Vec3& corner_point(std::size_t corner) const;  ///< programmed [mm]

  /// The same course on blocks of `programmed`, of which `compacted` was made: an element for each of
  /// `parts`, in order; only lines and filtered elements may have several.
  BlendedPath cut(std::shared_ptr<const Toolpath> programmed, std::shared_ptr<const CompactedPath> compacted,
                  std::span<const ElementPart> parts) const;
  /// Another path of the same program and blend weight, without elements.
  BlendedPath without_elements() const;
  /// Appends the elements of `part`, made without_elements() of this one; `motions`: what the numbers of its
  /// motions grow by; `done`: share of the whole path that is there then, by which room is made, (0, 1].
  void append(const BlendedPath& part, std::uint32_t motions, double done);
  void reserve(std::size_t elements);
  void shrink();  ///< gives back room that is not needed
  /// Appends an element of `length` [mm] of programmed segment `block`; index as PathElement::index. A line
  /// may follow one of the same block: then they are parts of it.
  std::uint32_t add(ElementKind kind, std::uint32_t block, double length, std::uint32_t index = 0);
  /// Appends the curve that begins `transition` [mm] before the end of `block` and ends as much after it.
  std::uint32_t add_corner(ElementKind kind, std::uint32_t block, double transition, double length);
  /// Appends the part of `block` that `course`, from s = 0 to its length, follows. A path holds either fitted
  /// elements and dwells, or none.
  std::uint32_t add_fitted(std::uint32_t block, std::span<const CourseKnot> course);
  /// Begins a smooth curve at `knot`, whose spans add_curve() appends.
  void begin_curve(const CourseKnot& knot) {
    knots_.push_back(knot);
    ++curves_;
  }
  /// Appends the span of a smooth curve from the knot given last to `to`; it begins on `block`.
  std::uint32_t add_curve(std::uint32_t block, const CourseKnot& to);
  /// Appends segment `i` of the executed path.
  std::uint32_t add_executed(std::uint32_t i);
  void set_blend_weight(double alpha) { alpha_ = alpha; }  ///< of all cubic blends

 private:
  struct Entry {
    double s = 0;
    std::uint32_t block = 0;
    std::uint32_t index : 29 = 0;
    ElementKind kind : 3 = ElementKind::line;
  };
  struct CornerPlan {
    Vec3 point, in, out;
  };

  std::uint32_t knot_count() const { return static_cast<std::uint32_t>(knots_.size()); }
  std::span<const CourseKnot> course(std::size_t i) const;
  CornerPlan plan_of(std::size_t corner) const;

  std::shared_ptr<const Toolpath> programmed_;
  std::shared_ptr<const CompactedPath> compacted_;
  std::shared_ptr<const ExecutedPath> executed_;
  std::vector<Entry> entries_;
  std::vector<double> transitions_;     ///< a corner
  std::vector<std::uint32_t> corners_;  ///< element of each
  std::vector<CourseKnot> knots_;       ///< of fitted elements and curves, one after the other
  std::size_t curves_ = 0;
  double length_ = 0;
  double alpha_ = 2.5;
};

}  // namespace feedscope
