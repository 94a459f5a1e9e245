#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "core/kinematics/kinematic_chain.h"
#include "core/machine/machine.h"
#include "core/toolpath/axis_courses.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// True if a setting matters only on a machine with rotary axes: tool_length_mm, orientation_tolerance_deg,
/// part_angle_x_deg ...
bool is_rotary_setting(std::string_view key);

inline constexpr const char* orientation_tolerance_key = "orientation_tolerance_deg";
/// Orientation tolerance in force [deg].
double orientation_tolerance_deg(const Settings& settings);

/// Permitted jump of an axis' velocity where blocks meet, as a share of its change within an interpolation
/// period: the usual overload factor of 1.2 of a Sinumerik (MD32310) allows (1.2 - 1) A t_cy (SINUMERIK
/// 840D/828D, Basic Functions, B1).
inline constexpr double jump_share = 0.2;

/// Limits of the axes of a machine where rotary axes turn along the path of the tip, by the derivatives of
/// every axis along it (KinematicChain::courses(); core/models/README.md, "Rotary axes").
class TurnLimiter {
 public:
  /// `chain`: of the machine; both outlive it. Settings read: orientation_tolerance_deg, program_tolerance
  /// (whether the program's tolerances take precedence), interpolation_period_s, and whether the jerk is
  /// limited.
  TurnLimiter(const Machine& machine, const KinematicChain& chain, const Settings& settings,
              const PartOnMachine& part);

  /// The rotary axes in the order of the chain.
  const std::vector<const RotaryAxis*>& axes() const { return axes_; }
  /// True if tool length and part zero are known, and so how X, Y and Z follow the rotary axes.
  bool knows_linear() const { return part_.known; }

  /// Sets limits and tilt of a turn along its segment of `path` (AxisCourses), for the rotary axes, and for
  /// the linear ones under tool centre point control.
  void set_limits(const Toolpath& path, SegmentTurn& turn) const;

  /// Step and longest reach of the joint where segment `segment` of `path` meets the next one; its limit is
  /// not set yet. `before`, `behind`: turns along the two; null for none.
  ///
  /// It reaches over the two segments (joint_shape()), less far where the angle would leave the programmed
  /// one by more than the orientation tolerance.
  TurnJoint join(const Toolpath& path, std::size_t segment, const SegmentTurn* before,
                 const SegmentTurn* behind) const;
  /// The joints at the other ends of the two segments of a joint; null for none.
  struct Neighbours {
    const TurnJoint* last = nullptr;
    const TurnJoint* next = nullptr;
  };
  /// Shortens the reach where that is faster: while an axis still turns near the place, it limits the tip
  /// that goes on. Where it is faster still, the velocities jump by jump_share. Sets the limit like
  /// set_limit().
  void choose_reach(const Toolpath& path, const SegmentTurn* before, const SegmentTurn* behind,
                    const Neighbours& beside, TurnJoint& joint) const;
  /// Sets limit and ramp, like set_limits(), by the bend of the course that the joint and its neighbours
  /// cause within its reach.
  void set_limit(const Toolpath& path, const SegmentTurn* before, const SegmentTurn* behind,
                 const Neighbours& beside, TurnJoint& joint) const;
  /// True if stopping the tip is faster at a joint whose limit and ramp are set (stop_is_faster()).
  bool stops(const Toolpath& path, const SegmentTurn* before, const SegmentTurn* behind,
             const TurnJoint& joint) const;
  /// True if the model computes a bound that no control can beat: velocities and accelerations are used
  /// whole, jerks are not limited (`jerk=off` of a bound). set_bound() then replaces the limits set before.
  bool is_bound() const { return is_bound_; }
  void set_bound(const Toolpath& path, SegmentTurn& turn) const;
  void set_bound(const Toolpath& path, const SegmentTurn* before, const SegmentTurn* behind,
                 TurnJoint& joint) const;

 private:
  /// One of the two segments that meet.
  struct Side {
    std::size_t segment = 0;
    double length = 0;                  // [mm]
    const SegmentTurn* turn = nullptr;  ///< along it; null: none
    std::array<double, 3> slopes{};     ///< of A, B and C at the place [rad/mm]
    double speed_up = 0;                ///< along it [mm/s2]
    double ramp_up = 0;                 ///< how fast that begins [mm/s3]
    double held_from = 0;               ///< reach from which the joint limits the ramps on all of it [mm]
  };
  /// Joint of two segments: the one before it, and the one after it.
  struct Meeting {
    std::array<Side, 2> sides;
    std::array<double, 3> angles{};
    bool at_tip = false;
  };

  Meeting meeting_of(const Toolpath& path, const SegmentTurn* before, const SegmentTurn* behind,
                     const TurnJoint& joint) const;
  void add_turn(const Toolpath& path, const SegmentTurn& turn, AxisCourses& courses) const;
  void add_linear(const CurvePoint& at, std::span<const Series> angles, AxisCourses& courses) const;
  AxisCourses bend_of(const Toolpath& path, const Meeting& meeting, const Neighbours& beside,
                      const TurnJoint& joint) const;
  TurnLimit rounded_limit(const Meeting& meeting, const AxisCourses& bend, const TurnJoint& joint) const;
  double share_for_bend(const Meeting& meeting, const TurnJoint& joint, std::size_t i,
                        double acceleration) const;
  double speed_for_velocity(const Meeting& meeting, const TurnJoint& joint, std::size_t i,
                            double velocity) const;
  TurnLimit jump_limit(const Toolpath& path, const Meeting& meeting, const TurnJoint& joint) const;
  std::vector<Series> angles_at(const std::array<double, 3>& angles,
                                const std::array<double, 3>& slopes) const;
  double speed_up(const CurvePoint& at, const SegmentTurn* turn) const;
  double ramp_up(const CurvePoint& at, const SegmentTurn* turn) const;
  double tilt_at(const std::array<double, 3>& angles) const;
  /// Orientation tolerance where segment `segment` meets the next one: the tighter of the two [rad].
  double tolerance_at(const Toolpath& path, std::size_t segment) const;

  const Machine& machine_;
  const KinematicChain& chain_;
  std::vector<const RotaryAxis*> axes_;
  PartOnMachine part_;
  double tolerance_ = 0;          ///< of the orientation where the program gives none [rad]
  bool follows_program_ = true;   ///< it may give one: OTOL, CYCLE832, TA of cycle 32 and of M128
  double contour_tolerance_ = 0;  ///< where the program gives none [mm]
  double period_ = 0;             ///< [s]
  bool is_bound_ = false;
};

}  // namespace feedscope
