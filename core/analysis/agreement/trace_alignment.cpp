#include "core/analysis/agreement/trace_alignment.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

TraceAlignment::TraceAlignment(const TraceOnProgram& trace, const Agreement& agreement)
    : trace_(&trace), agreement_(&agreement) {
  const double begin = std::max(trace.law.first_s(), agreement.simulated.first_s());
  shift_ = trace.law.at(begin + agreement.margin) - agreement.simulated.at(begin + agreement.margin);
}

double TraceAlignment::at_place(double time) const {
  const TimeLaw::Place place = agreement_->simulated.place_at(time);
  if (std::isnan(place.s) || place.s < trace_->law.first_s() || place.s > trace_->law.last_s()) {
    return MatchedRecord::unmatched;
  }
  const double at =
      place.share > 0 ? trace_->law.at(place.s, place.share, agreement_->margin) : trace_->law.at(place.s);
  const auto next = std::ranges::upper_bound(trace_->lost, at, {}, &LostStretch::from);
  return next != trace_->lost.begin() && at < std::prev(next)->to && at > std::prev(next)->from
             ? MatchedRecord::unmatched
             : at;
}

double TraceAlignment::at_time(double time) const {
  const double at = time + shift_;
  return at < trace_->record.time.front() || at > trace_->record.time.back() ? MatchedRecord::unmatched : at;
}

double TraceAlignment::end_time() const {
  return trace_ == nullptr || trace_->law.empty() ? 0 : trace_->law.times().back() - shift_;
}

}  // namespace feedscope
