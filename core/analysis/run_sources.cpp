#include "core/analysis/run_sources.h"

namespace feedscope {

bool RunSources::has(QuantitySource source) const {
  switch (source) {
    case QuantitySource::motion:
      return true;
    case QuantitySource::drives:
      return actual != nullptr;
    case QuantitySource::load:
      return load != nullptr;
  }
  return false;
}

InstantSampler::InstantSampler(const RunSources& sources, double from) {
  if (sources.actual) {
    actual_.emplace(*sources.actual, from);
  }
  if (sources.load) {
    load_.emplace(*sources.load);
  }
}

Instant InstantSampler::at(const State& state) {
  if (actual_) {
    actual_sample_ = actual_->at(state);
  }
  if (load_) {
    load_sample_ = load_->at(state);
  }
  return Instant(state, actual_ ? &actual_sample_ : nullptr, load_ ? &load_sample_ : nullptr);
}

}  // namespace feedscope
