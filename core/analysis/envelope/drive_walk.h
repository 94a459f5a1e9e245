#pragma once

#include <memory>

#include "core/analysis/contour/actual_path.h"
#include "core/analysis/envelope/band.h"
#include "core/drives/span_looks.h"
#include "core/trajectory/state_walk.h"

namespace feedscope {

/// Motion of the drives in a run, span by span, for a SpanEnvelope.
class DriveWalk {
 public:
  using Band = DriveBand;
  /// The actual path, shared.
  class Source {
   public:
    explicit Source(std::shared_ptr<const ActualPath> path) : path_(std::move(path)) {}
    const ActualPath& path() const { return *path_; }
    double duration() const { return path_->trajectory().duration(); }

   private:
    std::shared_ptr<const ActualPath> path_;
  };

  /// `source` must outlive this.
  DriveWalk(const Source& source, double time);

  bool done() const { return walk_.done(); }
  double begin() const { return walk_.span().time; }
  double end() const { return walk_.span().end(); }
  SpanLooks looks() const { return {walk_.span(), rigid_}; }
  void add(Band& band, double time);
  void next();

 private:
  bool rigid_;
  ActualWalk walk_;
  ActualErrors errors_;
  StateWalk set_;
  double seen_ = -1;  ///< instant of `last_`: the end of a span is the start of the next [s]
  Band last_;
};

}  // namespace feedscope
