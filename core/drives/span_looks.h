#pragma once

#include "core/drives/set_span.h"

namespace feedscope {

/// Instants at which a span of the set path is sampled to find extremes of the actual motion: borders of at
/// least two parts of at most 2 ms, far below the response time of drives. Once the drives have settled they
/// follow the polynomial of the span smoothly: after 0.1 s the parts are 50 ms long, and at most a thousand.
/// This does not apply where axes with backlash or friction may reverse.
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
  /// Index of the first border after `time` [s]; count() + 1 if there is none.
  int first_after(double time) const;

 private:
  double start_;        ///< [s]
  double dense_time_;   ///< all dense parts together [s]
  double sparse_time_;  ///< [s]
  int dense_;           ///< parts
  int sparse_;
};

}  // namespace feedscope
