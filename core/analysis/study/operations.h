#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/analysis/run/run.h"

namespace feedscope {

/// Criterion for the start of a new operation.
enum class OperationSplit : std::uint8_t {
  none,
  tool,     ///< a tool change
  comment,  ///< a line with only a comment
};

/// Title of the operation before the first tool, or before the first comment.
inline constexpr const char* before_first_tool = "start";

/// Title of an operation whose comment has no words: "line 12".
std::string title_of_line(std::uint32_t line);

/// Segments of a toolpath that form one operation, [first, last).
struct Operation {
  std::string title;
  std::uint32_t line = 0;  ///< first line
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

/// Throws InputError with the nearest name unless `name` is "tool" or "comment".
OperationSplit operation_split(const std::string& name);

/// Splits a program by its `path`. Operations without a segment are omitted; all others together contain
/// every segment.
///
/// By tool: a new operation starts where the tool requested last is loaded ("tool 3"); the part before the
/// first one is "start". By comment: CAM systems head an operation with a line that contains only a comment,
/// (...), ;... or "* - ..." of Heidenhain, MSG("...") of Sinumerik. Of the comment lines between two motions
/// the last run of neighbouring ones counts, and of that the first with a letter. A subprogram belongs to the
/// calling operation unless it has headings of its own; where a loop or a return goes back, the operation of
/// the last heading above begins again, unless it is current.
std::vector<Operation> split_operations(const Program& program, const Toolpath& path, OperationSplit split);

/// Figures of one operation in one run.
struct OperationFigures {
  double time = 0;                   ///< [s], including rapids and dwells
  double cutting_time = 0;           ///< of the motions at a programmed feed [s]
  double cutting_length = 0;         ///< executed by them [mm]
  double contour_error = 0;          ///< largest, as ContourErrors::largest [mm]
  double cutting_contour_error = 0;  ///< of its feed motions [mm]
  Cause cause;                       ///< largest share of `time`, counted as by limiting_causes()
  double cause_time = 0;             ///< [s]

  /// Mean feed of the cutting motions [mm/s]; 0 without any.
  double mean_feed() const { return cutting_time > 0 ? cutting_length / cutting_time : 0; }
};

/// One per operation. A corner between two operations counts for the one that ends there. Linear.
std::vector<OperationFigures> figures_of(const std::vector<Operation>& operations,
                                         const Trajectory& trajectory);

/// Share of a time due to one cause.
struct CauseShare {
  Cause cause;
  double share = 0;  ///< of the whole
};
/// Shares of the causes in the cycle time of a run, largest first; slowing down counts for the cause of the
/// slower place ahead. Causes without time are omitted.
std::vector<CauseShare> limiting_causes(const Summary& summary);

}  // namespace feedscope
