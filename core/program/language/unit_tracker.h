#pragma once

#include <cstddef>
#include <optional>

#include "core/program/program.h"
#include "core/program/text/diagnostic_log.h"

namespace feedscope {

/// The unit of a program: that of its first motion with a length.
class UnitTracker {
 public:
  /// Both outlive it.
  UnitTracker(const ReadOptions& options, ReadProgram& program) : options_(options), program_(program) {}

  /// Unit until the program programs one.
  LengthUnit first() const { return options_.unit.value_or(LengthUnit::mm); }
  /// The program programs its unit.
  void set(LengthUnit unit) { programmed_ = unit; }

  /// Call after each line.
  void watch();
  /// Call after the last line; reports an assumed unit.
  void finish(DiagnosticLog& log);

 private:
  void settle();
  bool has_motion() const { return first_motion_ < program_.motions.size(); }

  const ReadOptions& options_;
  ReadProgram& program_;
  std::optional<LengthUnit> programmed_;
  std::size_t first_motion_ = 0;  ///< the first of ReadProgram::motions with a length, once settled_
  bool settled_ = false;
};

}  // namespace feedscope
