#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/analysis/run.h"

namespace feedscope {

/// What begins a new operation.
enum class OperationSplit : std::uint8_t {
  none,
  tool,     ///< another tool comes in
  comment,  ///< a line that holds a comment alone
};

/// Title of what runs before the first tool, or before the first comment.
inline constexpr const char* before_first_tool = "start";

/// Title of an operation whose comment holds no words: "line 12".
std::string title_of_line(std::uint32_t line);

/// Segments of a toolpath that are one operation, [first, last).
struct Operation {
  std::string title;
  std::uint32_t line = 0;  ///< that it begins with
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

/// Throws InputError with the nearest name for what is none of "tool" and "comment".
OperationSplit operation_split(const std::string& name);

/// Splits a program; operations without a segment are omitted, all others together hold every segment.
///
/// By tool: where the tool comes in that the program asked for last ("tool 3"); what runs before the first
/// one is "start". By comment: CAM systems head an operation with a line that holds a comment alone, (...),
/// ;... or "* - ..." of Heidenhain, MSG("...") of Sinumerik. Of the comment lines between two motions the
/// last run of neighbouring ones counts, and of that the first that holds a letter. A subprogram belongs to
/// the operation that calls it unless it has headings of its own; where a loop or a return goes back, the
/// operation of the last heading above begins again, unless it is under way.
std::vector<Operation> split_operations(const LoadedProgram& program, OperationSplit split);

/// Figures of one operation in one run.
struct OperationFigures {
  double time = 0;                   ///< [s]; rapids and dwells included
  double cutting_time = 0;           ///< of the motions at a programmed feed [s]
  double cutting_length = 0;         ///< executed by them [mm]
  double contour_error = 0;          ///< largest [mm], as ContourErrors::largest
  double cutting_contour_error = 0;  ///< of its feed motions [mm]
  Cause cause;                       ///< that most of `time` is due to, as limiting_causes() counts
  double cause_time = 0;             ///< [s]

  /// While cutting [mm/s]; 0 if it does not cut.
  double mean_feed() const { return cutting_time > 0 ? cutting_length / cutting_time : 0; }
};

/// One a operation. A corner between two operations counts for the one that ends there. Linear.
std::vector<OperationFigures> figures_of(const std::vector<Operation>& operations,
                                         const Trajectory& trajectory);

/// Part of a time with its cause.
struct CauseShare {
  Cause cause;
  double share = 0;  ///< of the whole
};
/// What the cycle time of a run is due to, largest first; slowing down counts for what sets the speed of the
/// slower place ahead. Causes without time are omitted.
std::vector<CauseShare> limiting_causes(const Summary& summary);

}  // namespace feedscope
