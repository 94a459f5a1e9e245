#pragma once

// Room `program`: NC text to a ReadProgram. reader.h finds the dialect; a folder a dialect reads it
// (language: words, variables, flow; geometry: frames, compensation, motions; cycles) into blocks with modal
// state resolved: absolute, metric, with arcs, pauses, path control and diagnostics. text/, tools/, path/ and
// cycles/ are shared by the dialects.

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

/// Turn of an arc block; centre and axis are resolved from I J K, R, plane and modes.
struct ArcWords {
  Vec3 center = Vec3::Zero();  ///< at equal distances from both ends, at the start point's height along the
                               ///< axis [mm]
  Vec3 axis = Vec3::UnitZ();   ///< unit vector; the motion is counter-clockwise seen against it
  double turns = 0;  ///< whole turns on top of the partial one; 1 for a full circle, whose ends coincide
  /// From `center` to the programmed centre, which need not be at equal distances from both ends [mm].
  Vec3 misfit = Vec3::Zero();
};

/// A block that moves or waits, modal state resolved: absolute, metric, modal words filled in.
struct MotionBlock {
  Vec3 target =
      Vec3::Zero();  ///< position at the block's end; last known one for axes with an unknown place [mm]
  double feed = 0;   ///< programmed feed [mm/s]; 0: as fast as the axes allow (rapids, missing feed)
  double dwell = 0;  ///< [s], dwells only
  std::uint32_t line = 0;  ///< 1-based line in the source
  /// Arcs: index into ReadProgram::arcs; machine moves: into ReadProgram::machine_moves.
  std::int32_t arc = -1;
  std::uint16_t path_control = 0;  ///< index into Program::path_controls
  std::uint16_t spindle = 0;       ///< index into Program::spindles
  Motion motion = Motion::line;
  Pause pause = Pause::dwell;  ///< of Motion::dwell
  bool on_curve = false;       ///< part of a curve of the program
};

/// A tool called by the program.
struct ToolChange {
  std::string name;        ///< number or name
  std::uint32_t line = 0;  ///< of its first use
};

enum class CutterSource : std::uint8_t {
  unknown,  ///< no source: the programmed contour is shown
  asked,    ///< ReadOptions
  program,  ///< the program itself
  table,    ///< a tool table
};

/// "not known", "asked for", "program", "tool table".
std::string_view to_string(CutterSource source);

/// A cutter for whose radius the program is compensated.
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

/// Content of a program, independent of its dialect.
struct Program {
  std::shared_ptr<const SourceText> source;
  Dialect dialect = Dialect::iso;  ///< in which it was read
  ProgramUnit unit;                ///< of its first motion
  /// Lines with words, readable or not, up to the program's end; in loops and calls counted each time they
  /// run.
  std::uint64_t block_count = 0;
  std::vector<PathControl> path_controls;  ///< the first is the machine's
  std::vector<SpindleState> spindles;      ///< the first is the state before any spindle word
  std::vector<ToolChange> tools;           ///< in the order of their first use
  std::vector<CutterUse> cutters;          ///< of compensation, in the order of their first use
  std::vector<OffsetUse> work_offsets;     ///< in the order of their first use
  WorkOffsets given_offsets;               ///< ReadOptions::offsets used for reading
  std::uint64_t call_count = 0;            ///< subprogram calls that were run
  std::vector<std::shared_ptr<const SourceText>> called_files;
  bool cut_off = false;  ///< at the limit of ReadOptions: the rest is missing
  /// Rotary and secondary axes that move; their time is not counted on a machine without them.
  std::vector<std::string> other_axes;
  /// Axes of other_axes that no machine counts: all but A, B and C.
  std::vector<std::string> cutting_axes;
  /// Bounds of the whole path, arcs with their full extent [mm]. The tool starts at X0 Y0 Z0, an assumed
  /// place that is not part of it: a coordinate is part of it from the first block that programs its axis, or
  /// from the start of the first feed motion.
  Bounds bounds;
  Bounds cutting_bounds;  ///< of the feed motions among it [mm]
  Bounds rapid_bounds;    ///< of the rapids among it [mm]
  std::vector<Diagnostic> diagnostics;
};

/// A program with its blocks, as read: build_toolpath() makes the path of them.
struct ReadProgram : Program {
  std::vector<MotionBlock> motions;
  std::vector<ArcWords> arcs;
  std::vector<MachineMove> machine_moves;
  std::vector<RotaryMove> rotary_moves;  ///< in their order
};

struct ReadOptions {
  std::optional<Dialect> dialect = std::nullopt;  ///< none: recognised from the text
  /// Omits "/" blocks, as with the control's block delete switch on.
  bool skip_deleted_blocks = false;
  /// Limit of the lines that loops and calls may run in addition to the program's own, so that an endless
  /// loop ends; cycles and curves may make 25 times as many motions.
  std::uint64_t repeat_limit = 2'000'000;
  std::size_t call_depth = 64;  ///< limit of nested calls
  /// Unit of lengths and feeds until the program sets one; none: mm, with a warning that it is assumed.
  std::optional<LengthUnit> unit = std::nullopt;
  CutterRadii radii = {};    ///< of cutters; they override program and tool table
  WorkOffsets offsets = {};  ///< until the program sets them itself; zero where not given
  /// Tool table for radii that the program does not set; empty: one in the program's folder, if there is any.
  std::filesystem::path tool_table = {};
  double table_unit = 1;  ///< of lengths in a tool table that does not give a unit [mm]
  /// The path is already that of the tool's centre, and compensation only adds wear: every cutter has radius
  /// 0, despite program and tool table, unless it is in `radii`.
  bool wear_only = false;
  bool simulate_cut_off = false;  ///< also simulate a program cut off by the limits
  std::string rotary_axes = {};   ///< axes of the machine: their positions are simulated and not reported

  bool operator==(const ReadOptions&) const = default;
};

/// Reads a program of any dialect; see README.md in this folder.
///
/// A wrong line becomes a diagnostic and reading goes on; `progress` may stop the reading (throws Cancelled).
/// A block with unreadable position words does not move; an impossible arc becomes a line to its end, so that
/// the position stays correct.
ReadProgram read_program(std::shared_ptr<const SourceText> source, Progress* progress = nullptr,
                         const ReadOptions& options = {});

}  // namespace feedscope
