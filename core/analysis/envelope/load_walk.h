#pragma once

#include <memory>
#include <utility>

#include "core/analysis/envelope/band.h"
#include "core/analysis/envelope/part_looks.h"
#include "core/analysis/run/run_sources.h"

namespace feedscope {

/// Cutting load of a run, part by part, for a SpanEnvelope.
class LoadWalk {
 public:
  using Band = LoadBand;
  /// The load of the run, shared.
  class Source {
   public:
    explicit Source(std::shared_ptr<const RunLoad> load) : load_(std::move(load)) {}
    const RunLoad& load() const { return *load_; }
    double duration() const { return load_->trajectory().duration(); }

   private:
    std::shared_ptr<const RunLoad> load_;
  };

  /// `source` must outlive this.
  LoadWalk(const Source& source, double time);

  bool done() const { return walk_.done(); }
  double begin() const { return walk_.part().time; }
  double end() const { return begin() + walk_.part().duration; }
  PartLooks looks() { return {trajectory_, walk_.part(), motion().curve()}; }
  void add(Band& band, double time);
  void next();

 private:
  const PartMotion& motion();

  const Trajectory& trajectory_;
  PartWalk walk_;
  std::optional<PartMotion> motion_;  ///< of the current part
  LoadSampler sampler_;
};

}  // namespace feedscope
