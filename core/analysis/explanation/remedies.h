#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/analysis/explanation/explanation.h"

namespace feedscope {

/// A change of setup values that may make a run faster.
struct Remedy {
  /// Keys and values as for --set, in the unit of the key: "X.jerk", "contour_tolerance_mm".
  std::vector<std::pair<std::string, SettingValue>> changes;
  /// Present value of a changed tolerance if it may differ from the setup's: the program's.
  std::optional<double> before = std::nullopt;
  /// Id of another machine of the library, "" for the same one. Its limits and settings are used with model,
  /// contour tolerance, times of pauses and positions of the setup that is changed.
  std::string machine = {};

  bool operator==(const Remedy&) const = default;
};

/// Changes worth trying where `why` applies: first those in its formula, then the compressor, limits of all
/// axes, contour tolerance, look-ahead, interpolation period and feed. Each once, and only those that the
/// model of `setup` reads and its bounds allow.
std::vector<Remedy> remedies(const Setup& setup, const Explanation& why,
                             std::span<const PathControl> feed_controls = {});
/// Changes for several causes, given in order of importance.
std::vector<Remedy> remedies(const Setup& setup, std::span<const Cause> causes,
                             std::span<const PathControl> feed_controls = {});

/// `setup` with the changes. Throws InputError as apply_setting and make_setup.
Setup with_remedy(Setup setup, const Remedy& remedy);
/// Command-line options for it. A change of `setup`, in addition to the options for that: "--tolerance 0.2",
/// "--set X.jerk=7.5"; another machine, in place of the options for `setup`: setup_options(), "--machine ID
/// --model ID --tolerance 0.1".
std::string as_options(const Remedy& remedy, const Setup& setup);
/// Factor on every feed of the program except rapids; 1 if the feed override does not change.
double feed_factor(const Remedy& remedy, const Setup& setup);

/// Motion with the change. Throws as ControlModel::simulate does.
Trajectory try_remedy(const LoadedProgram& program, const Setup& setup, const Remedy& remedy,
                      Progress* progress = nullptr);

/// Blocks of the programmed path, as segment indices, inclusive.
struct SegmentRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};
/// Blocks under way from one instant to another [s].
SegmentRange segments_between(const Trajectory& trajectory, double from, double to);
/// Time of a run of the same program for these blocks, including the corners at their ends [s]; on a smooth
/// curve from the place nearest to their first point to the place nearest to their last.
double passage_time(const Trajectory& trajectory, const SegmentRange& segments);

}  // namespace feedscope
