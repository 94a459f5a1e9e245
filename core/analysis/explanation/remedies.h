#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/analysis/explanation/explanation.h"

namespace feedscope {

/// A change that may make a run faster: values of a setup.
struct Remedy {
  /// Keys and values as for --set, in the unit of the key: "X.jerk", "contour_tolerance_mm".
  std::vector<std::pair<std::string, SettingValue>> changes;
  /// What holds now of the tolerance that is changed, where that may not be the setup's value: that of the
  /// program.
  std::optional<double> before = std::nullopt;
  /// Id of another machine of the library, "" for the same one: with its limits and settings, but with model,
  /// contour tolerance, times of pauses and positions of the setup that is changed.
  std::string machine = {};

  bool operator==(const Remedy&) const = default;
};

/// What is worth trying where `why` holds: first what its formula names, then the compressor, limits of all
/// axes, contour tolerance, look-ahead, interpolation period and feed. Only what the model of `setup` reads
/// and its bounds allow; each once.
std::vector<Remedy> remedies(const Setup& setup, const Explanation& why,
                             std::span<const PathControl> feed_controls = {});
/// The same for several causes, that which is worth most first.
std::vector<Remedy> remedies(const Setup& setup, std::span<const Cause> causes,
                             std::span<const PathControl> feed_controls = {});

/// `setup` with the changes. Throws InputError as apply_setting and make_setup.
Setup with_remedy(Setup setup, const Remedy& remedy);
/// How the command line asks for it. A change of `setup`, beside what asks for that: "--tolerance 0.2",
/// "--set X.jerk=7.5"; another machine, in place of what asks for `setup`: setup_options(), "--machine ID
/// --model ID --tolerance 0.1".
std::string as_options(const Remedy& remedy, const Setup& setup);
/// What the change makes of every feed of the program, rapids apart; 1 where it leaves the feed override
/// alone.
double feed_factor(const Remedy& remedy, const Setup& setup);

/// The motion with the change. Throws what ControlModel::simulate throws.
Trajectory try_remedy(const LoadedProgram& program, const Setup& setup, const Remedy& remedy,
                      Progress* progress = nullptr);

/// Blocks of the programmed path, as indices of its segments, both included.
struct SegmentRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};
/// The blocks under way from one instant to another [s].
SegmentRange segments_between(const Trajectory& trajectory, double from, double to);
/// Time that a run of the same program takes for them, the corners at their ends included [s]; on a smooth
/// curve from where it is nearest to the first of their points to where it is to the last.
double passage_time(const Trajectory& trajectory, const SegmentRange& segments);

}  // namespace feedscope
