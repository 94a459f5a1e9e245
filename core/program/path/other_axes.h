#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/language/line_runner.h"
#include "core/program/path/path_writer.h"
#include "core/program/program.h"

namespace feedscope {

/// Motion of an axis other than X, Y and Z.
enum class AxisMotion : std::uint8_t {
  positions,  ///< on its own, or with a rapid: the path of X, Y and Z is right
  cuts,       ///< in a feed move
  at_tip,     ///< in a feed move whose X, Y and Z are those of the tool's tip
};

/// Other properties of a block with rotary axes.
struct AxisBlock {
  bool alone = false;         ///< X, Y and Z do not move in it
  double feed = 0;            ///< of the rotary axes [rad/s]; 0: a rapid
  double time = 0;            ///< given by the program [s]; 0: none
  bool at_tip = false;        ///< in a feed motion or alone: X, Y and Z are those of the tool's tip
  bool great_circle = false;  ///< in a motion at the tip: RotaryMove::great_circle
  double per_degree = 0;      ///< in a motion at the tip: RotaryMove::per_degree [mm]
  /// Way of an endless axis to its angle: as written, the shortest, or always in this direction.
  enum class Way : std::uint8_t { written, shortest, positive, negative };
  Way way = Way::written;
};

/// Speed of rotary axes that move alone: F is in degrees where it is in `unit` [mm] for X, Y and Z; inverse
/// time stays the same.
AxisBlock turning_alone(const PathWriter& path, double unit, bool rapid);

/// Name under which a tool vector moves several axes.
inline constexpr std::string_view orientation_axis = "tool orientation";

/// Axes other than X, Y and Z. Program::other_axes names those that move. Each is reported once for each kind
/// of motion, unless it is a rotary axis of ReadOptions. ReadProgram::rotary_moves contains the moves of A, B
/// and C.
class OtherAxes {
 public:
  /// All outlive it.
  OtherAxes(ReadProgram& program, const LineRunner& lines, DiagnosticLog& log, const ReadOptions& options)
      : program_(program), lines_(lines), log_(log), options_(options) {}

  /// Moves an axis to `target` [mm], [deg]; orientation_axis means several
  /// axes.
  void move(std::string_view axis, double target, AxisMotion motion, std::uint32_t column,
            const AxisBlock& block = {});
  /// Makes the control turn the rotary axes so that the tool has this unit direction in shown coordinates.
  void turn_tool(const Vec3& direction, int side = 0, double feed = 0);
  /// Makes the control turn the rotary axes during the block so that the tool reaches this unit direction in
  /// shown coordinates (tool vectors of five-axis programs). Reports a machine without rotary axes.
  void orient_tool(const Vec3& direction, AxisMotion motion, std::uint32_t column,
                   const AxisBlock& block = {});
  /// Sends all of them to zero.
  void turn_to_zero(double feed = 0);
  /// True if the machine has rotary axes.
  bool turns() const { return !options_.rotary_axes.empty(); }

 private:
  struct Axis {
    std::string name;
    std::array<bool, 3> reported{};  ///< by AxisMotion
  };

  static Message moves_text(std::string_view axis, double target, AxisMotion motion);
  RotaryMove& move_of_block();
  void note_turn(std::size_t axis, double target, AxisMotion motion, std::uint32_t column,
                 const AxisBlock& block);
  void report_feed(char axis, bool at_tip, std::uint32_t column);

  ReadProgram& program_;
  const LineRunner& lines_;
  DiagnosticLog& log_;
  const ReadOptions& options_;
  std::vector<Axis> axes_;
  std::array<double, 3> programmed_{};  ///< last words of A, B and C [deg]
  std::array<double, 3> at_{};          ///< resulting angles, including whole turns [deg]
};

}  // namespace feedscope
