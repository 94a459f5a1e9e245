#pragma once

// Room `blend`: the path that the control executes. A Toolpath becomes a BlendedPath: corner blends,
// connecting arcs and curves in place of corners, exact stops, each within the contour tolerance in force
// (path_rules.h). corner.h has the geometry of one corner.

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

/// `blend`: a cubic blend in a corner; `connecting_arc`: a circular arc in one; `filtered`: a segment as
/// drawn by smoothing filters, whose course only the motion contains; `fitted`: such a segment as a curve by
/// path length, for its own motion; `curve`: a span of a smooth curve through several blocks.
enum class ElementKind : std::uint8_t { line, arc, blend, connecting_arc, dwell, filtered, fitted, curve };

/// One geometric piece of the path that the control executes.
struct PathElement {
  Vec3 start;                 ///< [mm]; as programmed for a filtered element
  Vec3 end;                   ///< [mm]
  double s = 0;               ///< path length at the start, from the path's beginning [mm]
  double length = 0;          ///< [mm]; 0 for a dwell
  std::uint32_t segment = 0;  ///< of the programmed path; for a blend, the one that ends at its corner
  std::uint32_t index = 0;    ///< blends and connecting arcs: of the corner; filtered: of the motion;
                              ///< fitted and curves: of the first knot; lines: number of preceding parts
                              ///< of the same line
  ElementKind kind = ElementKind::line;
};

/// Course of one element, prepared for many evaluations.
class ElementCurve {
 public:
  ElementKind kind = ElementKind::line;
  double length = 0;  ///< [mm]
  Vec3 start;         ///< [mm]
  Vec3 end;           ///< [mm]
  Vec3 direction;     ///< lines: unit; zero for a dwell; filtered: along the programmed chord
  Arc arc;            ///< arcs and connecting arcs
  CubicBlend blend;   ///< blends
  std::span<const CourseKnot> course;  ///< fitted, curves; owned by the path, which must outlive this
  std::optional<CourseSpan> span;      ///< curves

  /// Position and derivatives by path length at `s` from the element's start, clamped to it [mm]. For a
  /// filtered element, the chord; Trajectory::state_at_path follows the actual course.
  CurvePoint at(double s) const;
  bool is_arc() const { return kind == ElementKind::arc || kind == ElementKind::connecting_arc; }
};

/// Part of an element on one block of the program: from `q` [mm] along it to the next part.
struct ElementPart {
  std::uint32_t element = 0;
  std::uint32_t block = 0;
  double q = 0;  ///< 0 for the first part of an element [mm]
};

/// Executed geometry: programmed segments, shortened where corner blends are inserted. Stores the programmed
/// path, and per element only additional data: 16 bytes per element, 12 more per corner.
class BlendedPath {
 public:
  BlendedPath() = default;
  /// `compacted`: result of compaction of `programmed` by the control, if any.
  BlendedPath(std::shared_ptr<const Toolpath> programmed, std::shared_ptr<const CompactedPath> compacted);
  explicit BlendedPath(std::shared_ptr<const Toolpath> programmed)
      : BlendedPath(std::move(programmed), std::shared_ptr<const CompactedPath>()) {}
  /// `executed`: replaces `programmed` on the control; may grow until its segments are added.
  BlendedPath(std::shared_ptr<const Toolpath> programmed, std::shared_ptr<const ExecutedPath> executed);

  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }
  double length() const { return length_; }  ///< [mm]
  ElementKind kind(std::size_t i) const { return entries_[i].kind; }
  std::uint32_t segment(std::size_t i) const { return entries_[i].block; }
  std::uint32_t index(std::size_t i) const { return entries_[i].index; }
  double s(std::size_t i) const { return i < size() ? entries_[i].s : length_; }
  double length(std::size_t i) const { return s(i + 1) - entries_[i].s; }
  /// Start of line element `i` on its segment of base() [mm].
  double line_offset(std::size_t i) const;
  bool in_corner(std::size_t i) const {
    return kind(i) == ElementKind::blend || kind(i) == ElementKind::connecting_arc;
  }
  /// As in_corner(), or part of a corner that the control rounds in its own way.
  bool rounds_corner(std::size_t i) const {
    return in_corner(i) || (executed_ && executed_->rounds_corner(static_cast<std::uint32_t>(i)));
  }
  PathElement element(std::size_t i) const;
  ElementCurve curve(std::size_t i) const;
  /// Index of the element at path length `s`, the earlier one at a border; 0 <= s <= length().
  std::size_t element_at(double s) const;

  /// Programmed path, null only for an empty path.
  const std::shared_ptr<const Toolpath>& programmed() const { return programmed_; }
  /// Path of the elements: the executed or the compacted path if there is one.
  const Toolpath& base() const {
    return executed_ ? executed_->path : compacted_ ? compacted_->path : *programmed_;
  }
  bool is_executed() const { return executed_ != nullptr; }
  /// Segment of base() for element `i`.
  std::size_t base_segment_of(std::size_t i) const {
    return executed_ ? entries_[i].index : base_segment(entries_[i].block);
  }
  /// Segment that determines line, feed and rapid of element `i`.
  const Segment& source_segment(std::size_t i) const {
    return executed_ ? executed_->path.segments[entries_[i].index] : programmed_->segments[entries_[i].block];
  }
  /// Segment of base() that contains programmed segment `block`; without an executed path.
  std::size_t base_segment(std::uint32_t block) const;
  /// First programmed segment contained in segment `i` of base(), without an executed path.
  std::size_t first_block(std::size_t i) const { return compacted_ ? compacted_->first[i] : i; }
  /// Number of programmed segments in segment `i` of base().
  std::size_t blocks_of_base(std::size_t i) const { return first_block(i + 1) - first_block(i); }
  const std::shared_ptr<const CompactedPath>& compacted() const { return compacted_; }  ///< null if none

  /// Corners that the control rounds in its own way, in order of their elements.
  std::size_t rounded_count() const { return executed_ ? executed_->corners.size() : 0; }
  const RoundedCorner& rounded(std::size_t i) const { return executed_->corners[i]; }
  /// Corners in order of their elements.
  std::size_t corner_count() const { return corners_.size(); }
  std::uint32_t corner_element(std::size_t corner) const { return corners_[corner]; }
  double corner_transition(std::size_t corner) const { return transitions_[corner]; }  ///< T [mm]
  std::size_t curve_count() const { return curves_; }                                  ///< smooth curves
  /// Geometry of a corner: turn [rad], transition and distance of the corner point [mm].
  Corner corner(std::size_t corner) const;
  double turn(std::size_t corner) const;               ///< turn only [rad]
  double min_radius(std::size_t corner) const;         ///< [mm]
  const Vec3& corner_point(std::size_t corner) const;  ///< programmed [mm]

  /// Same course on blocks of `programmed`, the source of `compacted`: an element for each of `parts`, in
  /// order; only lines and filtered elements may have several.
  BlendedPath cut(std::shared_ptr<const Toolpath> programmed, std::shared_ptr<const CompactedPath> compacted,
                  std::span<const ElementPart> parts) const;
  /// Another path of the same program and blend weight, without elements.
  BlendedPath without_elements() const;
  /// Appends the elements of `part`, made by without_elements() of this path. `motions`: offset for the
  /// indices of its motions; `done`: share of the whole path then complete, used to reserve memory, (0, 1].
  void append(const BlendedPath& part, std::uint32_t motions, double done);
  void reserve(std::size_t elements);
  void shrink();  ///< releases unused memory
  /// Appends an element of `length` [mm] of programmed segment `block`; index as in PathElement::index.
  /// Consecutive lines of the same block are parts of it.
  std::uint32_t add(ElementKind kind, std::uint32_t block, double length, std::uint32_t index = 0);
  /// Appends a curve that begins `transition` [mm] before the end of `block` and ends as far after it.
  std::uint32_t add_corner(ElementKind kind, std::uint32_t block, double transition, double length);
  /// Appends the part of `block` that `course` follows, from s = 0 to its length. A path with fitted elements
  /// contains only these and dwells.
  std::uint32_t add_fitted(std::uint32_t block, std::span<const CourseKnot> course);
  /// Begins a smooth curve at `knot`; add_curve() appends its spans.
  void begin_curve(const CourseKnot& knot) {
    knots_.push_back(knot);
    ++curves_;
  }
  /// Appends the span of a smooth curve from the previous knot to `to`; it begins on `block`.
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
  std::vector<double> transitions_;     ///< per corner
  std::vector<std::uint32_t> corners_;  ///< element of each
  std::vector<CourseKnot> knots_;       ///< of fitted elements and curves, consecutive
  std::size_t curves_ = 0;
  double length_ = 0;
  double alpha_ = 2.5;
};

}  // namespace feedscope
