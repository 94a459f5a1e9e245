#include "core/analysis/contour/actual_figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/roots.h"
#include "core/drives/span_looks.h"

namespace feedscope {
namespace {

constexpr std::size_t spans_per_report = 4096;

/// Searches the largest figures span by span, in order of time. Samples more closely where a figure may rise
/// between three samples above its largest value so far. Uses values only, no derivatives: slides jump where
/// friction breaks loose.
class SpanFigures {
 public:
  explicit SpanFigures(const ActualPath& path) : path_(path), errors_(path) {}

  void add(ActualWalk& walk) {
    const SpanLooks looks(walk.span(), path_.response().is_rigid());
    std::array<Look, 3> last;
    last[2] = look(walk, looks.at(0));
    for (int i = 0; i <= looks.count(); ++i) {
      std::shift_left(last.begin(), last.end(), 1);
      if (i < looks.count()) {
        last[2] = look(walk, looks.middle(i));
        cutting_ += last[2].cuts ? looks.duration(i) : 0;
        sum_ += last[2].of[error] * looks.duration(i);
      } else {
        last[2] = look(walk, looks.at(i));
      }
      if (last[1].cuts != last[2].cuts) {
        look_at_border(walk, last[1], last[2]);
      }
      if (i == 0) {
        narrow_at_end(walk, last[1], last[2], first_share);
        continue;
      }
      narrow(walk, last[0], last[1], last[2]);
    }
    narrow_at_end(walk, last[1], last[2], 1 - first_share);
  }

  ActualFigures result() const {
    ActualFigures figures = figures_;
    figures.mean_contour_error = cutting_ > 0 ? sum_ / cutting_ : 0;
    return figures;
  }

 private:
  static constexpr std::size_t error = 3;  ///< index of the contour error, after the three following errors
  static constexpr double first_share = 1e-3;
  static constexpr double width = 1e-9;  ///< to which an instant is narrowed down [s]
  static constexpr int steps = 60;       ///< at most, to narrow it down
  struct Look {
    double time = 0;             ///< [s]
    std::array<double, 4> of{};  ///< [mm]
    bool cuts = false;
    ActualWalk::Slides slides;
  };

  Look look(ActualWalk& walk, double time) {
    const std::uint32_t element = walk.span().element;
    const ActualMotion actual = walk.within_span(time);
    figures_.largest_following_error =
        figures_.largest_following_error.cwiseMax(actual.following_error.cwiseAbs());
    Look look{time, {}, false, walk.slides()};
    for (std::size_t i = 0; i < error; ++i) {
      look.of[i] = std::abs(actual.following_error[static_cast<Eigen::Index>(i)]);
    }
    if (!errors_.is_cut(element)) {
      return look;
    }
    const PathDeviation::Foot foot = errors_.foot(actual.position, element);
    look.cuts = errors_.is_of_cut(foot, element);
    look.of[error] = look.cuts ? std::sqrt(foot.squared) : 0;
    if (look.of[error] > figures_.worst.error) {
      figures_.worst = {look.of[error],
                        errors_.at(actual.position + actual.following_error, element),
                        time,
                        path_.trajectory().line_of(element),
                        actual.position,
                        actual.position - foot.offset};
    }
    return look;
  }

  double largest(std::size_t figure) const {
    return figure == error ? figures_.worst.error
                           : figures_.largest_following_error[static_cast<Eigen::Index>(figure)];
  }
  /// Whether a figure may exceed its largest value so far if it rises above `high` by as much as it falls to
  /// `low`.
  bool may_rise(std::size_t figure, double high, double low) const {
    constexpr double rounding = 1 + 1e-9;
    return high >= low && 2 * high - low > largest(figure) * rounding;
  }

  void narrow(ActualWalk& walk, const Look& before, const Look& at, const Look& after) {
    for (std::size_t i = 0; i < at.of.size(); ++i) {
      if (at.of[i] >= std::max(before.of[i], after.of[i]) &&
          may_rise(i, at.of[i], std::min(before.of[i], after.of[i]))) {
        least_place({before.time, after.time}, width, steps, [&](double time) {
          walk.go_back(before.slides);
          return -look(walk, time).of[i];
        });
        walk.go_back(after.slides);
      }
    }
  }

  /// Between two samples only one of which counts: the error may be largest where it begins or ceases to
  /// count.
  void look_at_border(ActualWalk& walk, const Look& before, const Look& after) {
    double from = before.time;
    double to = after.time;
    for (int i = 0; i < steps && to - from > width; ++i) {
      const double middle = (from + to) / 2;
      walk.go_back(before.slides);
      (look(walk, middle).cuts == before.cuts ? from : to) = middle;
    }
    walk.go_back(after.slides);
  }

  /// Between two samples one of which is at an end of the span: a figure may first rise from there.
  void narrow_at_end(ActualWalk& walk, const Look& before, const Look& after, double share) {
    const bool rises = std::ranges::any_of(std::array<std::size_t, 4>{0, 1, 2, 3}, [&](std::size_t i) {
      return may_rise(i, std::max(before.of[i], after.of[i]), std::min(before.of[i], after.of[i]));
    });
    if (rises) {
      walk.go_back(before.slides);
      const Look between = look(walk, before.time + share * (after.time - before.time));
      walk.go_back(after.slides);
      narrow(walk, before, between, after);
    }
  }

  const ActualPath& path_;
  ActualErrors errors_;
  ActualFigures figures_;
  double sum_ = 0;
  double cutting_ = 0;
};

}  // namespace

ActualFigures actual_figures(const ActualPath& path, Progress* progress) {
  SpanFigures figures(path);
  std::size_t spans = 0;
  for (ActualWalk walk(path.response()); !walk.done(); walk.next_span()) {
    figures.add(walk);
    if (progress != nullptr && ++spans % spans_per_report == 0) {
      progress->report(walk.span().time / path.trajectory().duration());
    }
  }
  return figures.result();
}

}  // namespace feedscope
