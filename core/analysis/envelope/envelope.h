#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/envelope/drive_walk.h"
#include "core/analysis/envelope/load_walk.h"
#include "core/analysis/envelope/motion_envelope.h"
#include "core/analysis/envelope/rotary_walk.h"
#include "core/analysis/envelope/span_envelope.h"

namespace feedscope {

/// Level of detail of a run for charts: minimum and maximum of every quantity in every pixel column.
class Envelope {
 public:
  Envelope() = default;
  /// `sources`: of the trajectory's run. Throws Cancelled if `progress` is cancelled.
  explicit Envelope(std::shared_ptr<const Trajectory> trajectory, const RunSources& sources = {},
                    Progress* progress = nullptr);

  /// One band for each pair of neighbours in `times` [s], ascending. Columns outside the run are empty.
  std::vector<Band> columns(std::span<const double> times) const;
  /// As columns(), without rapids; empty where there is nothing else. Exact at their borders.
  std::vector<Band> cutting_columns(std::span<const double> times) const;
  /// Band of the whole run; empty for an empty trajectory.
  Band overall() const;
  /// Band of everything except rapids.
  const MotionBand& cutting() const { return motion_.cutting(); }
  const CauseTimes& causes() const { return motion_.causes(); }
  const RapidTimes& rapids() const { return motion_.rapids(); }
  /// Whether the run has quantities of this source.
  bool has(QuantitySource source) const;

 private:
  MotionEnvelope motion_;
  std::optional<SpanEnvelope<DriveWalk>> drives_;
  std::optional<SpanEnvelope<LoadWalk>> load_;
  std::optional<SpanEnvelope<RotaryWalk>> rotary_;
};

}  // namespace feedscope
