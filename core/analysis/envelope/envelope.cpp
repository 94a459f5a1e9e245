#include "core/analysis/envelope/envelope.h"

namespace feedscope {

Envelope::Envelope(std::shared_ptr<const Trajectory> trajectory, std::shared_ptr<const ActualPath> actual,
                   Progress* progress)
    : motion_(std::move(trajectory), progress) {
  if (actual) {
    drives_.emplace(DriveWalk::Source(std::move(actual)), progress);
  }
}

std::vector<Band> Envelope::columns(std::span<const double> times) const {
  std::vector<Band> bands(times.empty() ? 0 : times.size() - 1);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    bands[i].add(motion_.column(times[i], times[i + 1]));
  }
  if (drives_) {
    drives_->columns(times, [&](std::size_t i, const DriveBand& band) { bands[i].add(band); });
  }
  return bands;
}

Band Envelope::overall() const {
  Band band;
  band.add(motion_.overall());
  if (drives_) {
    band.add(drives_->overall());
  }
  return band;
}

}  // namespace feedscope
