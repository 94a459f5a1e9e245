#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/analysis/run.h"

namespace feedscope {

/// What became of a stretch of a program in another version of it.
enum class ProgramChange : std::uint8_t {
  none,     ///< the same motions with the same feeds
  feed,     ///< the same motions with other feeds
  path,     ///< other motions in their place
  removed,  ///< in the old one alone
  added,    ///< in the new one alone
};
inline constexpr std::size_t program_change_count = static_cast<std::size_t>(ProgramChange::added) + 1;
/// For files: "none", "feed", "path", "removed", "added".
std::string_view program_change_key(ProgramChange change);
/// For people: "same motions", "other feed", ...
std::string_view program_change_title(ProgramChange change);

/// One side of a stretch.
struct StretchSide {
  std::uint32_t first_line = 0;  ///< least source line of its motions; 0: there are none
  std::uint32_t last_line = 0;   ///< largest
  double time = 0;               ///< of the run on it [s]
  double length = 0;             ///< programmed [mm]
};

struct ProgramStretch {
  ProgramChange change = ProgramChange::none;
  StretchSide old, now;
  double gained() const { return old.time - now.time; }  ///< [s]
};

struct ProgramDifference {
  /// By ProgramChange: sums of all stretches; lines without meaning.
  struct Sum {
    std::size_t count = 0;
    StretchSide old, now;
  };
  std::array<Sum, program_change_count> sums;
  std::vector<ProgramStretch> stretches;  ///< in the order of the programs; the times of a side add up to its
                                          ///< cycle time
  const Sum& of(ProgramChange change) const { return sums[static_cast<std::size_t>(change)]; }
  /// Share of the new path's length that the old one has too.
  double same_share() const;
};

/// Two programs, each run, matched by their programmed paths (match_toolpaths). A corner that the control
/// rounds counts half for each of its blocks. Linear in both runs, and the cost of match_toolpaths.
ProgramDifference compare_programs(const Run& old, const Run& now);

/// Places of the stretches whose times differ most, `most` at most and each by more than a microsecond, in
/// the order of the programs.
std::vector<std::size_t> largest_changes(const ProgramDifference& difference, std::size_t most);

}  // namespace feedscope
