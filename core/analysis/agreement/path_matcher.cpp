#include "core/analysis/agreement/path_matcher.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/analysis/agreement/line_guide.h"

namespace feedscope {
namespace {

constexpr double window_share = 3;       // times the recorded distance
constexpr double window_tolerances = 4;  // additional tolerances
constexpr double finest = 1e-3;          // [mm]: shorter distances are zero
constexpr double rounded_pause = 4e-3;   // [mm]: extent of a pause whose positions are rounded to 1 um
constexpr double noise_of_a_pause = 10;  // times the noise: extent of a pause
constexpr double noise_of_the_end = 3;   // times the noise: of the last position from the end of the path
constexpr double usual_growth = 0.02;    // of the distance travelled: a cut corner leaves the path faster
constexpr double search_growth = 1.05;   // of the distance travelled between two searches for a lost path

struct Found {
  std::size_t part = 0;  ///< from point `part` to the next
  double share = 0;
  double distance = std::numeric_limits<double>::infinity();
};

class Matcher {
 public:
  Matcher(const ProgrammedCourse& course, const MotionRecord& record, const MatchOptions& options,
          const MatchHints& hints)
      : course_(course),
        record_(record),
        options_(options),
        hints_(hints),
        equal_(std::max(rounded_pause, noise_of_a_pause * options.noise)),
        end_reach_(std::max(finest, noise_of_the_end * options.noise)) {}

  MatchedRecord match(std::size_t from, Progress* progress) {
    const std::size_t count = record_.place.size();
    matched_.s.assign(count, MatchedRecord::unmatched);
    matched_.distance.assign(count, 0);
    matched_.first = matched_.end = matched_.arrival = count;
    const auto start = find_start(from, progress);
    if (!start) {
      return std::move(matched_);
    }
    ProgressSteps steps(progress, count);
    matched_.first = *start;
    Vec3 before = course_.visible(record_.place[*start]);
    double next_search = 0;
    for (std::size_t i = *start; i < count; ++i) {
      steps.at(i);
      const Vec3 here = course_.visible(record_.place[i]);
      moved_ += (here - before).norm();
      before = here;
      if (at_end() && moved_ > options_.tolerance) {
        break;
      }
      if (moved_ < next_search) {
        continue;
      }
      Found found = nearest(here, allowed(i));
      if (hints_.guide != nullptr && found.distance > options_.tolerance) {
        // A control that joins blocks reports the last one of them while it is on the first.
        found = nearest(here, {});
      }
      matched_.distance[i] = static_cast<float>(found.distance);
      if (found.distance <= options_.tolerance) {
        if (found.part > part_ || found.share > share_) {
          const bool was_lost = i > 0 && std::isnan(matched_.s[i - 1]);
          usual_ = was_lost ? found.distance : std::min(found.distance, usual_ + usual_growth * moved_);
        }
        part_ = found.part;
        share_ = found.share;
        moved_ = next_search = 0;
        matched_.s[i] = s_of(found);
        matched_.distance[i] = static_cast<float>(distance_around(found, here));
        matched_.end = i + 1;
        if (matched_.arrival == count && at_end()) {
          matched_.arrival = i;
        }
      } else {
        next_search = search_growth * moved_;
      }
    }
    for (std::size_t i = matched_.first; i < matched_.end; ++i) {
      matched_.lost += std::isnan(matched_.s[i]) ? 1 : 0;
    }
    return std::move(matched_);
  }

 private:
  double s_of(const Found& found) const {
    return course_.s(found.part) + found.share * (course_.s(found.part + 1) - course_.s(found.part));
  }
  bool at_end() const {
    return course_.length() - s_of({part_, share_, 0}) <= std::max(end_reach_, same_point);
  }

  Found project(std::size_t part, double least_share, const Vec3& place) const {
    const Vec3& a = course_.point(part);
    const Vec3 along = course_.point(part + 1) - a;
    const double square = along.squaredNorm();
    const double share =
        std::clamp(square > 0 ? (place - a).dot(along) / square : least_share, least_share, 1.0);
    return {part, share, (place - a - share * along).norm()};
  }

  /// By the program lines, widened by the control's deviation from them [mm].
  LineGuide::Range allowed(std::size_t sample) const {
    if (hints_.guide == nullptr) {
      return {};
    }
    const double slack = window_tolerances * options_.tolerance;
    const LineGuide::Range range = hints_.guide->range(sample, s_of({part_, share_, 0}) - slack);
    return {range.from - slack, range.to + slack};
  }

  /// First of the nearest allowed places ahead.
  Found nearest(const Vec3& place, const LineGuide::Range& range) {
    std::size_t begin = part_;
    double begin_share = share_;
    if (range.from > s_of({part_, share_, 0})) {
      while (begin + 2 < course_.size() && course_.s(begin + 1) <= range.from) {
        ++begin;
      }
      const double length = course_.s(begin + 1) - course_.s(begin);
      begin_share = length > 0 ? std::clamp((range.from - course_.s(begin)) / length, 0.0, 1.0) : 0;
    }
    const double limit = course_.seen_length(begin) +
                         begin_share * (course_.seen_length(begin + 1) - course_.seen_length(begin)) +
                         window_share * moved_ + window_tolerances * options_.tolerance;
    double least = std::numeric_limits<double>::infinity();
    ahead_.clear();
    for (std::size_t part = begin;
         part + 1 < course_.size() &&
         (part == begin || (course_.seen_length(part) <= limit && course_.s(part) <= range.to));
         ++part) {
      ahead_.push_back(project(part, part == begin ? begin_share : 0, place));
      least = std::min(least, ahead_.back().distance);
    }
    Found best;
    for (const Found& here : ahead_) {
      const bool near_enough = best.distance <= std::max(least, usual_) + equal_;
      if (near_enough && best.share < 1) {
        break;  // the nearest place is inside this part: a nearer one after it belongs to another pass
      }
      if (here.distance < best.distance) {
        best = here;
      } else if (near_enough) {
        break;
      }
    }
    return best;
  }

  /// Distance from the path around a place that was found, both ahead and back. At a cut corner the nearest
  /// place is on one side while the motion already counts as on the other, or still does.
  double distance_around(const Found& found, const Vec3& place) const {
    constexpr double reach = 4;  // times the distance
    double least = found.distance;
    const double s = s_of(found);
    const double from = s - reach * found.distance;
    const double to = s + reach * found.distance;
    for (std::size_t part = found.part; part > 0 && course_.s(part) > from; --part) {
      least = std::min(least, project(part - 1, 0, place).distance);
    }
    least = std::min(least, project(found.part, 0, place).distance);
    for (std::size_t part = found.part + 1; part + 1 < course_.size() && course_.s(part) < to; ++part) {
      least = std::min(least, project(part, 0, place).distance);
    }
    return least;
  }

  std::optional<std::size_t> find_start(std::size_t from, const Progress* progress) {
    if (course_.size() < 2) {
      return std::nullopt;
    }
    const std::size_t count = record_.place.size();
    for (std::size_t i = from; i < count && !hints_.anywhere; ++i) {
      if ((course_.visible(record_.place[i]) - course_.point(0)).norm() <= options_.tolerance &&
          allowed(i).from <= 0) {
        part_ = 0;
        share_ = 0;
        return i;
      }
    }
    double searched = 0;
    Vec3 last = Vec3::Constant(std::numeric_limits<double>::infinity());
    for (std::size_t i = from; i < count && searched < options_.most_searched; ++i) {
      stop_if_cancelled(progress);
      const Vec3 here = course_.visible(record_.place[i]);
      if ((here - last).norm() < options_.tolerance) {
        continue;
      }
      last = here;
      const LineGuide::Range range = allowed(i);
      for (std::size_t part = 0; part + 1 < course_.size(); ++part) {
        if (course_.s(part + 1) < range.from || course_.s(part) > range.to) {
          continue;
        }
        const Found found = project(part, 0, here);
        if (found.distance <= options_.tolerance) {
          part_ = found.part;
          share_ = found.share;
          return i;
        }
      }
      searched += static_cast<double>(course_.size());
    }
    return std::nullopt;
  }

  const ProgrammedCourse& course_;
  const MotionRecord& record_;
  const MatchOptions& options_;
  MatchHints hints_;
  /// Two places whose distances differ by less are equally near [mm]. During a pause at a turning point noise
  /// moves the found place forward, and it never goes back: without this, a later pass through there would
  /// become the nearer one.
  double equal_;
  /// Recent distance of the motion from the path [mm]. A motion parallel to the path, as one rounded to
  /// steps, is nearer to the way back just before a sharp corner: at this distance it is still on its way
  /// there.
  double usual_ = 0;
  double end_reach_;  ///< distance from the end within which it counts as reached [mm]
  MatchedRecord matched_;
  std::vector<Found> ahead_;  ///< candidates of one search, kept for their memory
  std::size_t part_ = 0;      ///< part of the last matching sample
  double share_ = 0;
  double moved_ = 0;  ///< distance since that sample [mm]
};

}  // namespace

MatchedRecord match_record(const ProgrammedCourse& course, const MotionRecord& record,
                           const MatchOptions& options, std::size_t from, Progress* progress) {
  return Matcher(course, record, options, {}).match(from, progress);
}

MatchedRecord match_record(const ProgrammedCourse& course, const MotionRecord& record,
                           const MatchOptions& options, const MatchHints& hints, std::size_t from,
                           Progress* progress) {
  return Matcher(course, record, options, hints).match(from, progress);
}

double noise_of(const MotionRecord& record) {
  constexpr double scale = 0.6745 * 8.3666;  // median of a normal distribution; sqrt(1 + 16 + 36 + 16 + 1)
  constexpr std::size_t most_looked_at = 100'000;
  constexpr std::size_t least_differences = 50;  // fewer come from a jump, not from noise
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> differences;
    for (std::size_t i = 4; i < record.place.size() && differences.size() < most_looked_at; ++i) {
      const auto at = [&](std::size_t back) { return record.place[i - back][axis]; };
      const double moved = std::abs(at(0) - at(4));
      if (moved > 0) {
        differences.push_back(std::abs(at(0) - 4 * at(1) + 6 * at(2) - 4 * at(3) + at(4)));
      }
    }
    if (differences.size() > least_differences) {
      const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
      std::nth_element(differences.begin(), middle, differences.end());
      largest = std::max(largest, *middle / scale);
    }
  }
  return largest;
}

}  // namespace feedscope
