#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/lessons/lesson.h"
#include "core/lessons/lesson_text.h"

namespace feedscope {

struct ClaimResult {
  double value = 0;  ///< of its quantity, in its unit
  double bound = 0;  ///< value compared with; for `between` the lower bound
  bool holds = false;
};

/// Simulations of a lesson, each made once on first use.
class LessonRuns {
 public:
  /// `lesson` must outlive this.
  explicit LessonRuns(const Lesson& lesson) : lesson_(lesson) {}

  /// Run of the start of the lesson with `changes`. Throws InputError if the program has errors, Cancelled,
  /// and as simulate_run does.
  const Run& run(const Changes& changes, Progress* progress = nullptr);
  /// Value in the quantity's unit. Throws as run(), and InputError if a ratio is undefined because the other
  /// run measures 0.
  double value(const LessonQuantity& quantity, Progress* progress = nullptr);
  ClaimResult check(const Claim& claim, Progress* progress = nullptr);
  /// All {numbers} of the lesson. Throws as value() does.
  WrittenNumbers numbers(Progress* progress = nullptr);

 private:
  /// Program as read on a machine: with its rotary axes and work offsets.
  const LoadedProgram& program(const std::filesystem::path& file, const Machine& machine, Progress* progress);

  const Lesson& lesson_;
  LessonSetups setups_;
  std::map<std::pair<std::filesystem::path, std::string>, LoadedProgram> programs_;  ///< by file and machine
  std::map<Changes, Run> runs_;
};

}  // namespace feedscope
