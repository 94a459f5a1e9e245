#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/analysis/run/run.h"

namespace feedscope {

/// Change of a stretch of a program in another version of it.
enum class ProgramChange : std::uint8_t {
  none,     ///< the same motions with the same feeds
  feed,     ///< the same motions with other feeds
  path,     ///< other motions instead
  removed,  ///< only in the old version
  added,    ///< only in the new version
};
inline constexpr std::size_t program_change_count = static_cast<std::size_t>(ProgramChange::added) + 1;
/// Key for files: "none", "feed", "path", "removed", "added".
std::string_view program_change_key(ProgramChange change);
/// Title for display: "same motions", "other feed", ...
std::string_view program_change_title(ProgramChange change);

struct StretchSide {
  std::uint32_t first_line = 0;  ///< smallest source line of its motions; 0 without any
  std::uint32_t last_line = 0;   ///< largest
  double time = 0;               ///< of the run on the stretch [s]
  double length = 0;             ///< programmed [mm]
};

struct ProgramStretch {
  ProgramChange change = ProgramChange::none;
  StretchSide old, now;
  double gained() const { return old.time - now.time; }  ///< [s]
};

struct ProgramDifference {
  /// Sums over all stretches, by ProgramChange; lines have no meaning.
  struct Sum {
    std::size_t count = 0;
    StretchSide old, now;
  };
  std::array<Sum, program_change_count> sums;
  std::vector<ProgramStretch> stretches;  ///< in the order of the programs; the times of a side add up to its
                                          ///< cycle time
  const Sum& of(ProgramChange change) const { return sums[static_cast<std::size_t>(change)]; }
  /// Share of the new path's length that is also in the old one.
  double same_share() const;
};

/// Compares the runs of two programs, matched by their programmed paths (match_toolpaths). A corner that the
/// control rounds counts half for each of its blocks. Linear in both runs, plus the cost of match_toolpaths.
ProgramDifference compare_programs(const Run& old, const Run& now);

/// Indices of the stretches whose times differ most, at most `most` and each by more than a microsecond, in
/// the order of the programs.
std::vector<std::size_t> largest_changes(const ProgramDifference& difference, std::size_t most);

}  // namespace feedscope
