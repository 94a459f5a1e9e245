#include "ui/report/blocks/feed_course.h"

#include <algorithm>

#include "core/analysis/contour/programmed_place.h"

namespace feedscope::ui {

namespace {

bool is_cut(const Segment& segment) {
  return segment.kind != SegmentKind::dwell && !segment.rapid && segment.feed > 0 && segment.length > 0;
}

/// Walks along the feed motions of a run and distributes their times to the parts.
class FeedWalk {
 public:
  FeedWalk(const Run& run, std::size_t parts)
      : trajectory_(*run.trajectory),
        toolpath_(*run.path),
        segments_(toolpath_.segments),
        time_(parts),
        programmed_(parts) {
    for (const Segment& segment : segments_) {
      length_ += is_cut(segment) ? segment.length : 0;
    }
    part_length_ = length_ / static_cast<double>(parts);
  }

  FeedCourse course() {
    bool cutting = false;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (is_cut(segments_[i])) {
        since_ = cutting ? since_ : time_at(i, 0) + pauses_before(i);
        walk(i);
        const bool ends = i + 1 == segments_.size() || !is_cut(segments_[i + 1]);
        if (ends) {
          take_time(time_at(i, 1));
        }
      }
      cutting = is_cut(segments_[i]);
    }
    return result();
  }

 private:
  double time_at(std::size_t segment, double share) const {
    return time_of(trajectory_, {static_cast<std::uint32_t>(segment), share});
  }
  /// Pause at the start of a segment, which time_of() does not contain [s].
  double pauses_before(std::size_t segment) const {
    double time = 0;
    for (; segment > 0 && segments_[segment - 1].kind == SegmentKind::dwell; --segment) {
      time += toolpath_.dwell_of(segments_[segment - 1]);
    }
    return time;
  }
  void take_time(double now) {
    time_[part_] += now - since_;
    since_ = now;
  }

  void walk(std::size_t i) {
    const Segment& segment = segments_[i];
    double at = 0;  // of the segment [mm]
    while (part_ + 1 < time_.size()) {
      const double border = part_length_ * static_cast<double>(part_ + 1) - done_;
      if (border >= segment.length) {
        break;
      }
      programmed_[part_] += (border - at) / segment.feed;
      take_time(time_at(i, border / segment.length));
      at = std::max(0.0, border);
      ++part_;
    }
    programmed_[part_] += (segment.length - at) / segment.feed;
    done_ += segment.length;
  }

  FeedCourse result() const {
    FeedCourse course{length_, {}, {}, {}};
    double lost = 0;
    for (std::size_t i = 0; i < time_.size(); ++i) {
      lost += time_[i] - programmed_[i];
      course.feed.push_back(time_[i] > 0 ? part_length_ / time_[i] : 0);
      course.programmed.push_back(programmed_[i] > 0 ? part_length_ / programmed_[i] : 0);
      course.lost.push_back(lost);
    }
    return course;
  }

  const Trajectory& trajectory_;
  const Toolpath& toolpath_;
  const std::vector<Segment>& segments_;
  std::vector<double> time_;        ///< of the parts [s]
  std::vector<double> programmed_;  ///< of the parts [s]
  double length_ = 0;
  double part_length_ = 0;
  double done_ = 0;   ///< length of the previous segments [mm]
  double since_ = 0;  ///< start of the time not yet in a part [s]
  std::size_t part_ = 0;
};

}  // namespace

FeedCourse feed_course(const Run& run, std::size_t parts) {
  const bool cuts = std::ranges::any_of(run.path->segments, is_cut);
  return cuts && !run.trajectory->pieces().empty() ? FeedWalk(run, parts).course() : FeedCourse();
}

}  // namespace feedscope::ui
