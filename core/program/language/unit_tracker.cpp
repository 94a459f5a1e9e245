#include "core/program/language/unit_tracker.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace feedscope {

namespace {

CutSize cut_size(const ReadProgram& program) {
  CutSize cut;
  for (const MotionBlock& motion : program.motions) {
    if (motion.motion == Motion::line || motion.motion == Motion::arc) {
      cut.feed = std::max(cut.feed, motion.feed);
    }
  }
  const Bounds& bounds = program.cutting_bounds;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double size = bounds.max[axis] - bounds.min[axis];
    cut.size[axis] = std::isfinite(size) ? size : 0;
  }
  return cut;
}

}  // namespace

void UnitTracker::watch() {
  while (!settled_ && has_motion()) {
    if (program_.motions[first_motion_].motion == Motion::dwell) {
      ++first_motion_;
    } else {
      settle();
    }
  }
}

void UnitTracker::settle() {
  if (settled_) {
    return;
  }
  settled_ = true;
  using Source = ProgramUnit::Source;
  program_.unit = {programmed_.value_or(first()), programmed_     ? Source::program
                                                  : options_.unit ? Source::asked
                                                                  : Source::assumed};
}

/// grbl and printers start in mm on every machine; only sizes that look like inches deserve a report.
void UnitTracker::finish(DiagnosticLog& log) {
  watch();
  settle();
  if (program_.unit.source != ProgramUnit::Source::assumed || !has_motion()) {
    return;
  }
  const CutSize cut = cut_size(program_);
  const bool inches = looks_like_inches(cut);
  if (options_.dialect == Dialect::grbl && !inches) {
    return;
  }
  Message hint = NC_("core", "give it as an import option: --unit mm or --unit inch");
  if (inches) {
    hint = message(NC_("core",
                       "{:.4g} x {:.4g} x {:.4g} mm cut at {:.4g} mm/min at most look like inches; give "
                       "--unit inch, or --unit mm if that is right"),
                   cut.size.x(), cut.size.y(), cut.size.z(), units::to_mm_min(cut.feed));
  }
  log.add(Severity::warning, "unit-assumed", 0, {program_.motions[first_motion_].line, 0, {}}, [&] {
    return DiagnosticLog::Text{NC_("core", "the program does not define its unit; mm is used"), hint};
  });
}

}  // namespace feedscope
