#include "core/program/path/drilling_cycle.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

namespace {

class Drill {
 public:
  Drill(PathWriter& path, const DrillingCycle& cycle) : path_(path), cycle_(cycle) {}

  void above(Vec3 hole) {
    hole[cycle_.axis] =
        std::max(path_.position()[cycle_.axis],
                 cycle_.motion == DrillingMotion::back_bore ? cycle_.initial : cycle_.retract);
    rapid(hole[cycle_.axis]);
    rapid(hole);
  }

  void hole() {
    switch (cycle_.motion) {
      case DrillingMotion::rapid_out:
      case DrillingMotion::feed_out:
        rapid(cycle_.retract);
        feed(cycle_.bottom);
        dwell();
        out(cycle_.motion == DrillingMotion::feed_out);
        break;
      case DrillingMotion::peck:
      case DrillingMotion::chip_break:
        pecks();
        out(false);
        break;
      case DrillingMotion::fine_bore:
        rapid(cycle_.retract);
        feed(cycle_.bottom);
        dwell();
        rapid(path_.position() + cycle_.aside);
        out(false);
        rapid(path_.position() - cycle_.aside);
        break;
      case DrillingMotion::back_bore:
        back_bore();
        break;
    }
  }

 private:
  void rapid(const Vec3& to) {
    if ((to - path_.position()).norm() > same_point) {
      path_.rapid(to);
    }
  }
  void rapid(double level) { rapid(at(level)); }
  void feed(double level) { path_.line(at(level)); }
  Vec3 at(double level) const {
    Vec3 place = path_.position();
    place[cycle_.axis] = level;
    return place;
  }
  void dwell() {
    if (cycle_.dwell > 0) {
      path_.dwell(cycle_.dwell);
    }
  }

  void out(bool at_feed) {
    if (at_feed) {
      feed(cycle_.retract);
    }
    rapid(cycle_.to_initial ? std::max(cycle_.initial, cycle_.retract) : cycle_.retract);
  }

  void pecks() {
    rapid(cycle_.retract);
    const double step = cycle_.peck > 0 ? cycle_.peck : cycle_.retract - cycle_.bottom;
    double to = 0;
    for (double count = 0, depth = cycle_.retract; depth > cycle_.bottom; ++count) {
      const double shorter = std::max(step - count * cycle_.peck_less, std::min(step, cycle_.peck_least));
      to = cycle_.peck_less > 0 ? to + shorter : (count + 1) * step;
      depth = cycle_.retract - to;
      depth = depth > cycle_.bottom + same_point ? depth : cycle_.bottom;
      feed(depth);
      if (depth > cycle_.bottom) {
        if (cycle_.motion == DrillingMotion::peck) {
          rapid(cycle_.retract);
        }
        rapid(std::min(depth + cycle_.clearance, cycle_.retract));
      }
    }
    dwell();
  }

  void back_bore() {
    rapid(path_.position() + cycle_.aside);
    rapid(cycle_.retract);
    rapid(path_.position() - cycle_.aside);
    feed(cycle_.bottom);
    dwell();
    rapid(path_.position() + cycle_.aside);
    rapid(cycle_.initial);
    rapid(path_.position() - cycle_.aside);
  }

  PathWriter& path_;
  const DrillingCycle& cycle_;
};

}  // namespace

double peck_count(const DrillingCycle& cycle) {
  const double least = cycle.peck_less > 0 ? std::min(cycle.peck, cycle.peck_least) : cycle.peck;
  return cycle.peck > 0 ? std::ceil((cycle.retract - cycle.bottom) / least) : 1;
}

void drill(PathWriter& path, const DrillingCycle& cycle, const Vec3& hole) {
  Drill drill(path, cycle);
  drill.above(hole);
  drill.hole();
}

}  // namespace feedscope
