#include "core/analysis/run/run_sources.h"

namespace feedscope {

bool RunSources::has(QuantitySource source) const {
  switch (source) {
    case QuantitySource::motion:
      return true;
    case QuantitySource::drives:
      return actual != nullptr;
    case QuantitySource::load:
      return load != nullptr;
    case QuantitySource::rotary:
      return rotary != nullptr;
  }
  return false;
}

bool RunSources::has(const QuantityInfo& quantity) const {
  if (!has(quantity.source) || quantity.source != QuantitySource::rotary) {
    return has(quantity.source);
  }
  const AxisInfo& axis = cause_axes[static_cast<std::size_t>(quantity.axis)];
  return axis.kind == AxisKind::rotary ? rotary->has(axis.name) : rotary->knows_linear();
}

InstantSampler::InstantSampler(const RunSources& sources, double from) {
  if (sources.actual) {
    actual_.emplace(*sources.actual, from);
  }
  if (sources.load) {
    load_.emplace(*sources.load);
  }
  rotary_ = sources.rotary.get();
}

Instant InstantSampler::at(const State& state) {
  if (actual_) {
    actual_sample_ = actual_->at(state);
  }
  if (load_) {
    load_sample_ = load_->at(state);
  }
  if (rotary_ != nullptr) {
    rotary_sample_ = rotary_->at(state);
  }
  return Instant(state, actual_ ? &actual_sample_ : nullptr, load_ ? &load_sample_ : nullptr,
                 rotary_ != nullptr ? &rotary_sample_ : nullptr);
}

}  // namespace feedscope
