#include "core/analysis/time/slow_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

constexpr double min_depth = 0.1;        // of the programmed feed
constexpr double depth_of_peak = 0.3;    // of the feed next to a dip, if that is less
constexpr double as_programmed = 0.999;  // of the programmed feed; anything faster is not slow
constexpr double min_loss = 1e-6;        // [s]
constexpr double spans_per_filter_time = 4;

/// Depth from which a dip counts, next to a feed with this share of the programmed one.
double depth_beside(double share) {
  return std::min(min_depth, depth_of_peak * share);
}

/// Achieved feed at one instant.
struct Level {
  double time = 0;        ///< [s]
  double length = 0;      ///< executed path length [mm]
  double speed = 0;       ///< [mm/s]
  double programmed = 1;  ///< [mm/s]
  std::uint32_t line = 0;

  double share() const { return speed / programmed; }
};

/// Data of a growing stretch.
class Account {
 public:
  void add_level(const Level& level) {
    if (level.share() < least_) {
      least_ = level.share();
      place_.slowest = level.time;
      place_.feed = std::max(0.0, level.speed);  // rounding may end a stop slightly off 0
      place_.programmed_feed = level.programmed;
      place_.line = level.line;
    }
  }

  void add_loss(const Level& a, const Level& b, double loss, Cause cause) {
    place_.loss += loss;
    add_cause(cause, loss);
    begin_ = std::min(begin_, a.time);
    end_ = std::max(end_, b.time);
    if (loss > (1 - as_programmed) * (b.time - a.time)) {
      extend(a.time, b.time, a.line, b.line);
    }
  }

  /// Appends `later`, which directly follows.
  void append(const Account& later) {
    place_.loss += later.place_.loss;
    begin_ = std::min(begin_, later.begin_);
    end_ = std::max(end_, later.end_);
    for (const auto& [cause, loss] : later.causes_) {
      add_cause(cause, loss);
    }
    if (later.least_ < least_) {
      least_ = later.least_;
      place_.slowest = later.place_.slowest;
      place_.feed = later.place_.feed;
      place_.programmed_feed = later.place_.programmed_feed;
      place_.line = later.place_.line;
    }
    if (later.is_slow_) {
      extend(later.place_.from, later.place_.to, later.place_.first_line, later.place_.last_line);
    }
  }

  void clear() {
    place_ = {};
    causes_.clear();
    least_ = std::numeric_limits<double>::infinity();
    is_slow_ = false;
    begin_ = std::numeric_limits<double>::infinity();
    end_ = 0;
  }

  bool counts() const { return is_slow_ && place_.loss > min_loss; }
  double loss() const { return place_.loss; }
  SlowPlace place() const {
    SlowPlace place = place_;
    const auto by_loss = [](const auto& a, const auto& b) { return a.second < b.second; };
    place.cause = std::max_element(causes_.begin(), causes_.end(), by_loss)->first;
    return place;
  }
  bool is_empty() const { return causes_.empty(); }
  std::span<const std::pair<Cause, double>> losses() const { return causes_; }
  /// The whole stretch, with its most important cause.
  SlowPlace stretch() const {
    SlowPlace stretch = place_;
    stretch.from = begin_;
    stretch.to = end_;
    stretch.first_line = is_slow_ ? place_.first_line : place_.line;
    stretch.last_line = is_slow_ ? place_.last_line : place_.line;
    const auto by_size = [](const auto& a, const auto& b) { return std::abs(a.second) < std::abs(b.second); };
    stretch.cause = std::max_element(causes_.begin(), causes_.end(), by_size)->first;
    return stretch;
  }

 private:
  void add_cause(Cause cause, double loss) {
    const auto found =
        std::find_if(causes_.begin(), causes_.end(), [&](const auto& entry) { return entry.first == cause; });
    if (found != causes_.end()) {
      found->second += loss;
    } else {
      causes_.emplace_back(cause, loss);
    }
  }

  void extend(double from, double to, std::uint32_t line, std::uint32_t other_line) {
    const auto [low, high] = std::minmax(line, other_line);
    place_.from = is_slow_ ? place_.from : from;
    place_.to = to;
    place_.first_line = is_slow_ ? std::min(place_.first_line, low) : low;
    place_.last_line = std::max(place_.last_line, high);
    is_slow_ = true;
  }

  SlowPlace place_;
  std::vector<std::pair<Cause, double>> causes_;  ///< with the loss of each [s]
  double least_ = std::numeric_limits<double>::infinity();
  bool is_slow_ = false;
  double begin_ = std::numeric_limits<double>::infinity();  ///< of the whole stretch [s]
  double end_ = 0;
};

/// Divides the course of the feed at its peaks as it comes in.
///
///   share   __             __      a peak counts, and the places are divided there, once the feed has
///             \    /\_    /        fallen by depth_beside() below it; until then everything after the
///              \__/   \__/         peak so far is kept apart in after_peak_
///            place 1|place 2
/// They are also divided where a rapid begins or ends, however slow the run is there.
class PlaceFinder {
 public:
  explicit PlaceFinder(const VisitStretch& visit) : visit_(visit) {}

  /// Closes the current place: a rapid begins or ends.
  void cut() {
    end_place();
    after_peak_.clear();
    rising_ = false;
    lowest_ = std::numeric_limits<double>::infinity();
  }

  void add_level(const Level& level) {
    const double share = level.share();
    if (!rising_) {
      lowest_ = std::min(lowest_, share);
      if (share > lowest_ + depth_beside(share)) {
        rising_ = true;
        peak_ = share;
      }
    } else if (share >= peak_) {
      peak_ = share;
      open_.append(after_peak_);
      after_peak_.clear();
    } else if (share < peak_ - depth_beside(peak_)) {
      close();
      std::swap(open_, after_peak_);
      after_peak_.clear();
      rising_ = false;
      lowest_ = share;
    }
    account().add_level(level);
  }

  void add_step(const Level& from, const Level& to, Cause cause) {
    const double loss = (to.time - from.time) - (to.length - from.length) / from.programmed;
    account().add_loss(from, to, loss, cause);
  }

  /// Returns the total loss [s].
  double finish() {
    end_place();
    return loss_;
  }

 private:
  Account& account() { return rising_ ? after_peak_ : open_; }

  void end_place() {
    open_.append(after_peak_);
    close();
  }

  void close() {
    loss_ += open_.loss();
    if (open_.counts()) {
      visit_(open_.place(), true, open_.losses());
    } else if (!open_.is_empty() && open_.loss() != 0) {
      visit_(open_.stretch(), false, open_.losses());
    }
    open_.clear();
  }

  const VisitStretch& visit_;
  double loss_ = 0;
  Account open_;
  Account after_peak_;
  bool rising_ = false;  ///< the feed has risen far enough from lowest_; searching for a peak
  double lowest_ = std::numeric_limits<double>::infinity();
  double peak_ = 0;
};

/// Instants of a part at which its feed may be extreme, including its ends.
class PartLevels {
 public:
  explicit PartLevels(const Trajectory& trajectory) : trajectory_(trajectory) {}

  const std::vector<Level>& of(PartWalk& walk) {
    const Part& part = walk.part();
    levels_.clear();
    if (part.law == Law::path_length) {
      add_polynomial(part);
    } else {
      const int spans =
          part.law == Law::filtered ? trajectory_.filtered_spans(part, spans_per_filter_time) : 2;
      PartMotion motion = walk.motion();
      for (int i = 0; i <= spans; ++i) {
        const State state = motion.state(part.duration * i / spans);
        levels_.push_back({state.time, state.path_length, state.speed, state.programmed_feed, state.line});
      }
    }
    return levels_;
  }

 private:
  void add_polynomial(const Part& part) {
    const double start = trajectory_.path().s(part.element);
    const double programmed = trajectory_.feed_of(part.element);
    const std::uint32_t line = trajectory_.line_of(part.element);
    const auto add = [&](double tau) {
      const LawPoint at = advance({part.q, part.v, part.a, part.j}, tau);
      const double time = std::min(part.time + tau, trajectory_.duration());  // rounding
      levels_.push_back({time, start + at.q, at.v, programmed, line});
    };
    add(0);
    const double extreme = part.j != 0 ? -part.a / part.j : -1;
    if (extreme > 0 && extreme < part.duration) {
      add(extreme);
    }
    add(part.duration);
  }

  const Trajectory& trajectory_;
  std::vector<Level> levels_;
};

/// Keeps the most important places of a run.
class SlowestPlaces {
 public:
  explicit SlowestPlaces(std::size_t most) : most_(std::max<std::size_t>(most, 1)) {}

  void add(const SlowPlace& place) {
    places_.push_back(place);
    if (places_.size() >= 2 * most_) {
      keep_worst();
    }
  }
  /// Places in order of time.
  std::vector<SlowPlace> finish() {
    keep_worst();
    std::ranges::sort(places_, {}, &SlowPlace::from);
    places_.shrink_to_fit();
    return std::move(places_);
  }

 private:
  void keep_worst() {
    if (places_.size() > most_) {
      const auto end = places_.begin() + static_cast<std::ptrdiff_t>(most_);
      std::ranges::nth_element(places_, end, std::ranges::greater(),
                               [](const SlowPlace& place) { return std::abs(place.loss); });
      places_.erase(end, places_.end());
    }
  }

  std::size_t most_;
  std::vector<SlowPlace> places_;
};

}  // namespace

double for_slow_stretches(const Trajectory& trajectory, const VisitStretch& visit, Progress* progress) {
  PlaceFinder finder(visit);
  PartLevels part_levels(trajectory);
  ProgressSteps steps(progress, trajectory.pieces().size());
  bool in_rapid = false;
  for (PartWalk walk(trajectory); !walk.done(); walk.next()) {
    steps.at(walk.part().piece);
    if (trajectory.path().kind(walk.part().element) == ElementKind::dwell) {
      continue;
    }
    const std::vector<Level>& levels = part_levels.of(walk);
    const Cause cause = limiting_cause(trajectory, walk.part());
    if (const bool rapid = trajectory.is_rapid(walk.part().element); rapid != in_rapid) {
      finder.cut();
      in_rapid = rapid;
    }
    finder.add_level(levels.front());
    for (std::size_t i = 1; i < levels.size(); ++i) {
      finder.add_step(levels[i - 1], levels[i], cause);
      finder.add_level(levels[i]);
    }
  }
  return finder.finish();
}

SlowPlaces find_slow_places(const Trajectory& trajectory, std::size_t most, Progress* progress) {
  SlowPlaces found;
  SlowestPlaces places(most);
  SlowestPlaces others(most);
  found.loss = for_slow_stretches(
      trajectory,
      [&](const SlowPlace& stretch, bool is_place, std::span<const std::pair<Cause, double>> /*losses*/) {
        found.count += is_place ? 1 : 0;
        (is_place ? places : others).add(stretch);
      },
      progress);
  found.places = places.finish();
  found.others = others.finish();
  return found;
}

}  // namespace feedscope
