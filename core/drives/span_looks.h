#pragma once

#include "core/drives/set_span.h"

namespace feedscope {

/// The instants at which a span of the set path is looked at to find extremes of what the drives make of it:
/// borders of parts of 2 ms at most, far below the time in which drives answer, and at least two parts. Once
/// the drives have settled they follow the polynomial of the span smoothly: after 0.1 s the parts are 50 ms,
/// and at most a thousand. Not where axes may turn round that have backlash or friction.
class SpanLooks {
 public:
  /// `rigid`: no axis has backlash or friction, as DriveResponse::is_rigid().
  SpanLooks(const SetSpan& span, bool rigid);

  /// Number of parts.
  int count() const { return dense_ + sparse_; }
  /// Border `i`, 0 to count() [s].
  double at(int i) const;
  double middle(int part) const { return (at(part) + at(part + 1)) / 2; }  ///< [s]
  double duration(int part) const { return at(part + 1) - at(part); }      ///< [s]
  /// The first border behind `time` [s]; count() + 1 if there is none.
  int first_after(double time) const;

 private:
  double start_;        ///< [s]
  double dense_time_;   ///< of the dense parts together [s]
  double sparse_time_;  ///< [s]
  int dense_;           ///< parts
  int sparse_;
};

}  // namespace feedscope
