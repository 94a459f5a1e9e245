#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "core/program/path/path_writer.h"

namespace feedscope {

/// A path written line by line, each motion on a line of its own.
class LineWriter {
 public:
  explicit LineWriter(OutsideCorner corner) : LineWriter(CompensationRule{.corner = corner}) {}
  explicit LineWriter(const CompensationRule& rule = {}) : rule_(rule) { path_.set_feed(10); }

  LineWriter& on(ToolSide side, double radius, Plane plane = Plane::xy) {
    path_.set_compensation(side, radius, rule_, plane, 1);
    return *this;
  }
  LineWriter& off() {
    path_.end_compensation();
    return *this;
  }
  LineWriter& rapid(const Vec3& to) {
    next();
    path_.rapid(to);
    return *this;
  }
  LineWriter& line(const Vec3& to) {
    next();
    path_.line(to);
    return *this;
  }
  LineWriter& arc(const Vec3& to, const Vec3& center, const Vec3& axis, double extra_turns = 0) {
    next();
    ArcRequest request;
    request.target = to;
    request.center = center;
    request.axis = axis;
    request.extra_turns = extra_turns;
    path_.arc_by_center(request);
    return *this;
  }
  LineWriter& dwell() {
    next();
    path_.dwell(1);
    return *this;
  }
  LineWriter& frame(const CoordinateFrame& frame) {
    path_.set_frame(frame);
    return *this;
  }
  PathWriter& path() { return path_; }

  ReadProgram finish() {
    path_.finish();
    program_.diagnostics = log_.take();
    return std::move(program_);
  }
  ReadProgram finish_clean() {
    ReadProgram program = finish();
    for (const Diagnostic& diagnostic : program.diagnostics) {
      ADD_FAILURE() << format(diagnostic, "path");
    }
    return program;
  }

 private:
  void next() {
    ++line_;
    path_.begin_line(line_, {line_, 0, {}});
    path_.program_axes();
  }

  ReadProgram program_;
  DiagnosticLog log_;
  PathWriter path_{program_, log_};
  CompensationRule rule_;
  std::uint32_t line_ = 0;
};

}  // namespace feedscope
