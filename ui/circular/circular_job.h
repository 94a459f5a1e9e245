#pragma once

#include <memory>
#include <vector>

#include "core/analysis/circularity/program_circles.h"
#include "ui/shared/job.h"
#include "ui/workbench/shown_run.h"

namespace feedscope::ui {

/// Result of the panel: a test, or a program, whose tests are moved out of `circles`.
struct CircularResult {
  std::vector<CircularTest> tests;
  std::optional<ProgramCircles> circles;

  bool actual() const { return circles ? circles->actual : !tests.empty() && tests.front().actual; }
};

/// A result and the index of its drawn test.
struct CircularShown {
  CircularResult result;
  int row = 0;
};

/// Simulates tests, or evaluates the circles of a run, on another thread.
class CircularJob : public Job<CircularResult> {
 public:
  using Deliver = std::function<void(Outcome)>;

  void test(std::vector<CircularRequest> requests, Setup setup, Deliver deliver);
  void evaluate(std::shared_ptr<const ShownRun> run, Deliver deliver);
};

}  // namespace feedscope::ui
