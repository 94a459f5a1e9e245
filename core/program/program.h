#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"
#include "core/base/progress.h"
#include "core/machine/work_offsets.h"
#include "core/program/dialect.h"
#include "core/program/machine_move.h"
#include "core/program/path_control.h"
#include "core/program/program_unit.h"
#include "core/program/rotary_move.h"
#include "core/program/spindle_state.h"
#include "core/program/text/source_text.h"
#include "core/program/tools/cutter_radii.h"

namespace feedscope {

/// `dwell`: no path, see Pause.
enum class Motion : std::uint8_t { rapid, line, arc, dwell };

/// How an arc block turns; centre and axis are resolved from I J K, R, plane and modes.
struct ArcWords {
  Vec3 center = Vec3::Zero();  ///< at equal distances from both ends, along the axis as the start point [mm]
  Vec3 axis = Vec3::UnitZ();   ///< unit vector; the motion is counter-clockwise seen against it
  double turns = 0;  ///< whole turns on top of the partial one; 1 for a full circle, whose ends coincide
  /// From `center` to where the program has it, which need not be as far from both ends [mm].
  Vec3 misfit = Vec3::Zero();
};

/// A block that moves or waits, modal state resolved: absolute, metric, modal words filled in.
struct MotionBlock {
  Vec3 target =
      Vec3::Zero();  ///< position at the block's end; of axes whose place is not known the last one [mm]
  double feed = 0;   ///< programmed feed [mm/s]; 0: as fast as the axes allow (rapids, missing feed)
  double dwell = 0;  ///< [s], dwells only
  std::uint32_t line = 0;  ///< 1-based line in the source
  std::int32_t arc = -1;   ///< arcs: index into Program::arcs; machine moves: into Program::machine_moves
  std::uint16_t path_control = 0;  ///< index into Program::path_controls
  std::uint16_t spindle = 0;       ///< index into Program::spindles
  Motion motion = Motion::line;
  Pause pause = Pause::dwell;  ///< of Motion::dwell
  bool on_curve = false;       ///< stands for a part of a curve of the program
};

/// A tool that the program asks for.
struct ToolChange {
  std::string name;        ///< number or name
  std::uint32_t line = 0;  ///< of its first use
};

enum class CutterSource : std::uint8_t {
  unknown,  ///< nobody says it: the programmed contour is shown
  asked,    ///< ReadOptions
  program,  ///< the program itself
  table,    ///< a tool table
};

/// "not known", "asked for", "program", "tool table".
std::string_view to_string(CutterSource source);

/// A cutter beside whose contour the program runs.
struct CutterUse {
  std::string tool;        ///< as a key of CutterRadii
  double radius = 0;       ///< [mm]
  std::uint32_t line = 0;  ///< of its first use
  CutterSource source = CutterSource::unknown;
};

/// A work offset that a program calls.
struct OffsetUse {
  std::string name;          ///< as a key of WorkOffsets
  std::uint32_t line = 0;    ///< of its first use
  std::uint64_t blocks = 0;  ///< motions while it is in force
  bool given = false;        ///< the program or ReadOptions give its zero point; else it is assumed as zero
  Vec3 zero = Vec3::Zero();  ///< its zero point when it was used last [mm]
};

/// What a program says, free of its dialect.
struct Program {
  std::shared_ptr<const SourceText> source;
  Dialect dialect = Dialect::iso;  ///< it was read as
  ProgramUnit unit;                ///< of its first motion
  /// Lines with words, readable or not, up to the program's end; in loops and calls each time they run.
  std::uint64_t block_count = 0;
  std::vector<MotionBlock> motions;
  std::vector<ArcWords> arcs;
  std::vector<MachineMove> machine_moves;
  std::vector<PathControl> path_controls;  ///< the first is the machine's
  std::vector<SpindleState> spindles;      ///< the first is that before the program says anything
  std::vector<ToolChange> tools;           ///< in the order of their first use
  std::vector<CutterUse> cutters;          ///< that compensation asks for, in the order of their first use
  std::vector<OffsetUse> work_offsets;     ///< in the order of their first use
  WorkOffsets given_offsets;               ///< ReadOptions::offsets that it was read with
  std::uint64_t call_count = 0;            ///< subprogram calls that were run
  std::vector<std::shared_ptr<const SourceText>> called_files;
  bool cut_off = false;  ///< at the limit of ReadOptions: what would follow is missing
  /// Rotary and secondary axes that move; on a machine that does not have them their time is not counted.
  std::vector<std::string> other_axes;
  /// Those of other_axes that no machine counts: other than A, B and C.
  std::vector<std::string> cutting_axes;
  std::vector<RotaryMove> rotary_moves;  ///< in their order
  /// Of the whole path, arcs with their full extent [mm]. The tool starts at X0 Y0 Z0, an assumed place that
  /// is not part of it: a coordinate belongs to it from the first block that programs its axis, or from the
  /// start of the first feed motion.
  Bounds bounds;
  Bounds cutting_bounds;  ///< of the feed motions among it [mm]
  Bounds rapid_bounds;    ///< of the rapids among it [mm]
  std::vector<Diagnostic> diagnostics;
};

struct ReadOptions {
  std::optional<Dialect> dialect = std::nullopt;  ///< none: recognised from the text
  /// As with the control's block delete switch on: "/" blocks are omitted.
  bool skip_deleted_blocks = false;
  /// Lines that loops and calls may run on top of the program's own, so that an endless loop ends; cycles and
  /// curves may make 25 times as many motions.
  std::uint64_t repeat_limit = 2'000'000;
  std::size_t call_depth = 64;  ///< of calls inside each other
  /// Of lengths and feeds until the program says its own; none: mm, and a warning that it is assumed.
  std::optional<LengthUnit> unit = std::nullopt;
  CutterRadii radii = {};    ///< of cutters, whatever program and tool table say
  WorkOffsets offsets = {};  ///< until the program sets them itself; those not given are zero
  /// Tool table for radii that the program does not set; empty: one beside the program, if there is any.
  std::filesystem::path tool_table = {};
  double table_unit = 1;  ///< of lengths in a tool table that does not name it [mm]
  /// The path is that of the tool's centre already, and compensation only adds wear: every cutter has radius
  /// 0, whatever program and tool table say, unless `radii` name it.
  bool wear_only = false;
  bool simulate_cut_off = false;  ///< a program that the limits cut off is simulated all the same
  std::string rotary_axes = {};   ///< that the machine has: their positions are simulated and not reported

  bool operator==(const ReadOptions&) const = default;
};

/// Reads a program of any dialect; see README.md beside this file.
///
/// A wrong line is a diagnostic and reading goes on; `progress` may stop the reading (throws Cancelled).
/// A block whose position words cannot be read does not move; an arc that cannot be one becomes a line to
/// its end, so that the position goes on.
Program read_program(std::shared_ptr<const SourceText> source, Progress* progress = nullptr,
                     const ReadOptions& options = {});

}  // namespace feedscope
