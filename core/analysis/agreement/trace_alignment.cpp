#include "core/analysis/agreement/trace_alignment.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

TraceAlignment::TraceAlignment(const TraceOnProgram& trace, const Agreement& agreement)
    : trace_(&trace), agreement_(&agreement) {
  const double begin = std::max(trace.law.first_s(), agreement.simulated.first_s());
  shift_ = trace.law.at(begin + agreement.margin) - agreement.simulated.at(begin + agreement.margin);
  const MatchedRecord& matched = trace.matched;
  std::size_t last = matched.first;
  for (std::size_t i = matched.first; i < matched.end; ++i) {
    if (std::isnan(matched.s[i])) {
      continue;
    }
    if (i - last > 2) {
      lost_.push_back({trace.record.time[last], trace.record.time[i]});
    }
    last = i;
  }
}

double TraceAlignment::at_place(double time) const {
  const TimeLaw::Place place = agreement_->simulated.place_at(time);
  if (std::isnan(place.s) || place.s < trace_->law.first_s() || place.s > trace_->law.last_s()) {
    return MatchedRecord::unmatched;
  }
  const double at =
      place.share > 0 ? trace_->law.at(place.s, place.share, agreement_->margin) : trace_->law.at(place.s);
  const auto next = std::ranges::upper_bound(lost_, at, {}, &Stretch::from);
  return next != lost_.begin() && at < std::prev(next)->to && at > std::prev(next)->from
             ? MatchedRecord::unmatched
             : at;
}

double TraceAlignment::at_time(double time) const {
  const double at = time + shift_;
  return at < trace_->record.time.front() || at > trace_->record.time.back() ? MatchedRecord::unmatched : at;
}

}  // namespace feedscope
