#include "core/analysis/contour/chord_error.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr double longest_chord = 20;                     // [mm]
constexpr double sharpest_corner = units::from_deg(36);  // [rad]
constexpr double least_length_share = 0.5;               // of a chord relative to its neighbour
constexpr double largest_curvature_ratio = 3;
constexpr std::size_t fewest_chords = 20;
constexpr double least_error = 1e-4;  // [mm]
constexpr double kept_by = 0.95;      // share of the chords

/// Walks over the corners of a path; remembers the corner at the start of the last chord.
class ChordWalk {
 public:
  explicit ChordWalk(const Toolpath& toolpath) : toolpath_(toolpath) {}

  std::vector<float> errors() {
    const std::size_t count = toolpath_.segments.size();
    for (std::size_t i = 1; i < count; ++i) {
      pass_corner(i);
    }
    return std::move(errors_);
  }

 private:
  bool is_chord(std::size_t i) const {
    const Segment& segment = toolpath_.segments[i];
    return segment.kind == SegmentKind::line && !segment.rapid && !segment.on_curve &&
           segment.length <= longest_chord;
  }

  /// Processes the corner before segment `i`.
  void pass_corner(std::size_t i) {
    if (!is_chord(i - 1) || !is_chord(i)) {
      has_corner_ = false;
      return;
    }
    const double before = toolpath_.segments[i - 1].length;
    const double after = toolpath_.segments[i].length;
    const Vec3 bend = (toolpath_.segments[i].end - toolpath_.start_of(i)) / after -
                      (toolpath_.start_of(i) - toolpath_.start_of(i - 1)) / before;
    static const double largest_bend = 2 * std::sin(sharpest_corner / 2);
    if (bend.squaredNorm() > largest_bend * largest_bend) {
      has_corner_ = false;
      return;
    }
    const Vec3 curvature = bend / ((before + after) / 2);
    if (has_corner_ && before_last_ >= least_length_share * before && after >= least_length_share * before) {
      add_chord(before, curvature_, curvature);
    }
    has_corner_ = true;
    curvature_ = curvature;
    before_last_ = before;
  }

  void add_chord(double length, const Vec3& from, const Vec3& to) {
    constexpr double ratio = largest_curvature_ratio * largest_curvature_ratio;
    const double from_square = from.squaredNorm();
    const double to_square = to.squaredNorm();
    if (from.dot(to) < 0 || from_square > ratio * to_square || to_square > ratio * from_square) {
      return;
    }
    // Two vectors that point to the centre of a circle from both ends of a chord have a mean shorter by the
    // cosine of half of its angle: m = k sqrt(1 - k^2 h^2/4).
    const double mean_square = (from + to).squaredNorm() / 4;
    const double square = length * length;
    const double root = std::sqrt(std::max(0.0, 1 - square * mean_square));
    const double curvature = std::sqrt(2 * mean_square / (1 + root));
    const double share = std::sqrt(std::max(0.0, 1 - square * curvature * curvature / 4));
    errors_.push_back(static_cast<float>(square * curvature / (4 * (1 + share))));
  }

  const Toolpath& toolpath_;
  std::vector<float> errors_;
  bool has_corner_ = false;  ///< a corner at the start of the last chord is known
  Vec3 curvature_ = Vec3::Zero();
  double before_last_ = 0;  ///< length of the chord before that corner [mm]
};

Message advice(const ChordError& error) {
  return message(
      NC_("core",
          "Heidenhain advises a contour tolerance of 110 to 200 % of the chord error: {:.2g} to {:.2g} mm"),
      least_advised_tolerance * error.value, largest_advised_tolerance * error.value);
}

}  // namespace

bool is_advised_tolerance(double share) {
  constexpr double rounding = 0.005;
  return share >= least_advised_tolerance - rounding && share <= largest_advised_tolerance + rounding;
}

std::optional<ChordError> chord_error_of(const Toolpath& toolpath) {
  std::vector<float> errors = ChordWalk(toolpath).errors();
  if (errors.size() < fewest_chords) {
    return std::nullopt;
  }
  const auto at =
      errors.begin() + static_cast<std::ptrdiff_t>(kept_by * static_cast<double>(errors.size() - 1));
  std::nth_element(errors.begin(), at, errors.end());
  const ChordError error{static_cast<double>(*at), errors.size()};
  return error.value >= least_error ? std::optional(error) : std::nullopt;
}

Diagnostic chord_error_message(const ChordError& error, const std::vector<PathControl>& feed_controls) {
  bool all_advised = !feed_controls.empty();
  for (const PathControl& control : feed_controls) {
    all_advised = all_advised && control.contour_tolerance &&
                  is_advised_tolerance(*control.contour_tolerance / error.value);
  }
  return {Severity::info,
          0,
          0,
          "chord-error",
          message(NC_("core",
                      "short lines lie about {:.2g} mm from the curve that they stand for: chord error, "
                      "estimated from {} lines"),
                  error.value, error.chords),
          all_advised ? Message() : advice(error)};
}

}  // namespace feedscope
