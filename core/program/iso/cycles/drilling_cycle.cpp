#include "core/program/iso/cycles/drilling_cycle.h"

#include <algorithm>
#include <cmath>

#include "core/program/cycles/tapping.h"

namespace feedscope::iso {

namespace {

class Drill {
 public:
  Drill(DrillPlan& plan, const DrillingCycle& cycle) : plan_(plan), cycle_(cycle) {}

  void hole() {
    switch (cycle_.motion) {
      case DrillingMotion::rapid_out:
      case DrillingMotion::feed_out:
        down();
        out(cycle_.motion == DrillingMotion::feed_out);
        break;
      case DrillingMotion::tap:
        plan_.rapid(cycle_.retract);
        tap({.safe = cycle_.retract,
             .surface = cycle_.retract,
             .bottom = cycle_.bottom,
             .stroke = cycle_.peck,
             .lift = cycle_.clearance,
             .dwell = cycle_.dwell},
            plan_);
        out(false);
        break;
      case DrillingMotion::peck:
      case DrillingMotion::chip_break:
        pecks();
        out(false);
        break;
      case DrillingMotion::fine_bore:
        down();
        plan_.shift(cycle_.aside);
        out(false);
        plan_.shift(-cycle_.aside);
        break;
      case DrillingMotion::back_bore:
        back_bore();
        break;
    }
  }

 private:
  void down() {
    plan_.rapid(cycle_.retract);
    plan_.feed(cycle_.bottom);
    plan_.dwell(cycle_.dwell);
  }

  void out(bool at_feed) {
    const double end = cycle_.to_initial ? std::max(cycle_.initial, cycle_.retract) : cycle_.retract;
    if (at_feed) {
      plan_.feed(cycle_.feeds_to_the_end ? end : cycle_.retract);
    }
    plan_.rapid(end);
  }

  void pecks() {
    plan_.rapid(cycle_.retract);
    const double step = cycle_.peck > 0 ? cycle_.peck : cycle_.retract - cycle_.bottom;
    double to = 0;
    for (double count = 0, depth = cycle_.retract; depth > cycle_.bottom; ++count) {
      const double shorter = std::max(step - count * cycle_.peck_less, std::min(step, cycle_.peck_least));
      to = cycle_.peck_less > 0 ? to + shorter : (count + 1) * step;
      depth = cycle_.retract - to;
      depth = depth > cycle_.bottom + same_point ? depth : cycle_.bottom;
      plan_.feed(depth);
      if (depth > cycle_.bottom) {
        if (cycle_.motion == DrillingMotion::peck) {
          plan_.rapid(cycle_.retract);
        }
        plan_.rapid(std::min(depth + cycle_.clearance, cycle_.retract));
      }
    }
    plan_.dwell(cycle_.dwell);
  }

  void back_bore() {
    plan_.shift(cycle_.aside);
    plan_.rapid(cycle_.retract);
    plan_.shift(-cycle_.aside);
    plan_.feed(cycle_.bottom);
    plan_.dwell(cycle_.dwell);
    plan_.shift(cycle_.aside);
    plan_.rapid(cycle_.initial);
    plan_.shift(-cycle_.aside);
  }

  DrillPlan& plan_;
  const DrillingCycle& cycle_;
};

}  // namespace

double peck_count(const DrillingCycle& cycle) {
  const double least = cycle.peck_less > 0 ? std::min(cycle.peck, cycle.peck_least) : cycle.peck;
  return cycle.peck > 0 ? std::ceil((cycle.retract - cycle.bottom) / least) : 1;
}

void rise(PathWriter& path, const DrillingCycle& cycle) {
  const double from = cycle.motion == DrillingMotion::back_bore ? cycle.initial : cycle.retract;
  const double level = path.position()[cycle.axis];
  DrillPlan up(cycle.axis, level);
  up.rapid(std::max(level, from));
  run(up, path, path.position());
}

void drill(PathWriter& path, const DrillingCycle& cycle, const Vec3& hole) {
  rise(path, cycle);
  const double above = path.position()[cycle.axis];
  DrillPlan plan(cycle.axis, above);
  plan.rapid(above);
  Drill(plan, cycle).hole();
  run(plan, path, hole);
}

}  // namespace feedscope::iso
