#include "core/analysis/envelope/envelope.h"

namespace feedscope {

Envelope::Envelope(std::shared_ptr<const Trajectory> trajectory, const RunSources& sources,
                   Progress* progress)
    : motion_(std::move(trajectory), progress) {
  if (sources.actual) {
    drives_.emplace(DriveWalk::Source(sources.actual), progress);
  }
  if (sources.load) {
    load_.emplace(LoadWalk::Source(sources.load), progress);
  }
  if (sources.rotary) {
    rotary_.emplace(RotaryWalk::Source(sources.rotary), progress);
  }
}

bool Envelope::has(QuantitySource source) const {
  switch (source) {
    case QuantitySource::motion:
      return true;
    case QuantitySource::drives:
      return drives_.has_value();
    case QuantitySource::load:
      return load_.has_value();
    case QuantitySource::rotary:
      return rotary_.has_value();
  }
  return false;
}

std::vector<Band> Envelope::columns(std::span<const double> times) const {
  std::vector<Band> bands(times.empty() ? 0 : times.size() - 1);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    bands[i].add(motion_.column(times[i], times[i + 1]));
  }
  const auto add = [&bands](std::size_t i, const auto& band) { bands[i].add(band); };
  if (drives_) {
    drives_->columns(times, add);
  }
  if (load_) {
    load_->columns(times, add);
  }
  if (rotary_) {
    rotary_->columns(times, add);
  }
  return bands;
}

std::vector<Band> Envelope::cutting_columns(std::span<const double> times) const {
  std::vector<Band> bands(times.empty() ? 0 : times.size() - 1);
  const std::vector<ColumnStretch> stretches = motion_.rapids().outside(times);
  for (const ColumnStretch& stretch : stretches) {
    bands[stretch.column].add(motion_.exact_column(stretch.from, stretch.to));
  }
  const auto add = [&bands](std::size_t i, const auto& band) { bands[i].add(band); };
  if (drives_) {
    drives_->exact_columns(stretches, add);
  }
  if (load_) {
    load_->exact_columns(stretches, add);
  }
  return bands;
}

Band Envelope::overall() const {
  Band band;
  band.add(motion_.overall());
  if (drives_) {
    band.add(drives_->overall());
  }
  if (load_) {
    band.add(load_->overall());
  }
  if (rotary_) {
    band.add(rotary_->overall());
  }
  return band;
}

}  // namespace feedscope
