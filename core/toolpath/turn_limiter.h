#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "core/kinematics/kinematic_chain.h"
#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Whether a setting counts only where a machine has rotary axes: tool_length_mm, orientation_tolerance_deg,
/// part_angle_x_deg ...
bool is_rotary_setting(std::string_view key);

inline constexpr const char* orientation_tolerance_key = "orientation_tolerance_deg";
/// The one in force [deg].
double orientation_tolerance_deg(const Settings& settings);

/// Of what an axis takes up within an interpolation period, that its velocity may jump where blocks meet: the
/// usual overload factor of 1.2 of a Sinumerik (MD32310) allows (1.2 - 1) A t_cy (SINUMERIK 840D/828D, Basic
/// Functions, B1).
inline constexpr double jump_share = 0.2;

/// What the axes of a machine allow where rotary axes turn along the path of the tip, by the derivatives of
/// every axis along it (KinematicChain::courses(); core/models/README.md, "Rotary axes").
class TurnLimiter {
 public:
  /// `chain`: of the machine; both outlive it. Of the settings it reads orientation_tolerance_deg,
  /// program_tolerance (whether those of the program go before) and interpolation_period_s.
  TurnLimiter(const Machine& machine, const KinematicChain& chain, const Settings& settings,
              const PartOnMachine& part);

  /// The rotary axes in the order of the chain.
  const std::vector<const RotaryAxis*>& axes() const { return axes_; }
  /// Tool length and part zero are known, so that it is known how X, Y and Z follow the rotary axes.
  bool knows_linear() const { return part_.known; }

  /// Sets limits and tilt of a turn along its segment of `path`: v q1 <= V, v^2 q2 <= s A, v^3 q3 <= s J
  /// with the derivatives q1, q2, q3 by the path, for the rotary axes, and for the linear ones under tool
  /// centre point control. The share 1 - s and what is not used is for ramps.
  void set_limits(const Toolpath& path, SegmentTurn& turn) const;

  /// Step and reach of the joint where segment `segment` of `path` meets the next one, its limit not yet set.
  /// `before`, `behind`: turns along the two; null for none.
  ///
  /// The second derivative of the angle rises along the reach before the place from 0 to step/reach, and
  /// falls behind it: over even blocks that is a cubic B-spline whose control points are the programmed
  /// angles. The angle leaves them by step times reach / 6, the orientation tolerance at most; the reach is
  /// the shorter of the two segments at most.
  TurnJoint join(const Toolpath& path, std::size_t segment, const SegmentTurn* before,
                 const SegmentTurn* behind) const;
  /// Sets its limit, as set_limits(). `last`, `next`: the joints at the other ends of the two segments; null
  /// for none. What they reach over half of a segment and more goes over into this one along it. A shorter
  /// reach is taken where that is faster: what the axis still turns beside the place holds the tip that goes
  /// on. The velocities may jump by jump_share, if that is faster.
  void set_limit(const Toolpath& path, const SegmentTurn* before, const SegmentTurn* behind,
                 const TurnJoint* last, const TurnJoint* next, TurnJoint& joint) const;
  /// Lowers the limit of a turn by the velocity that its axes still have where a joint at its end or start
  /// (`at_end`) reaches over half of it and more: there the axis turns more than on the rest.
  void hold_beside(const Toolpath& path, const TurnJoint& joint, bool at_end, SegmentTurn& turn) const;

 private:
  /// Largest derivatives of an axis by the path, and its limits.
  struct AxisCourse {
    double first = 0, second = 0, third = 0;
    double velocity = 0, acceleration = 0, jerk = 0;

    void add(const Series& course);
  };
  /// Derivatives of the angles of A, B and C at a joint: the second one, and the third ones before and behind
  /// it.
  struct Bend {
    std::array<double, 3> second{};
    std::array<double, 3> before{};
    std::array<double, 3> behind{};
  };
  /// X, Y, Z, A, B, C, as cause_axes.
  using Courses = std::array<AxisCourse, 6>;

  /// Where two segments meet.
  struct Meeting {
    std::array<double, 3> from{};  ///< slopes of A, B and C before it [rad/mm]
    std::array<double, 3> to{};    ///< and behind it
    std::array<double, 3> angles{};
    CurvePoint begin;                  ///< as the end of the first segment
    CurvePoint end;                    ///< as the start of the second one
    std::array<double, 2> speed_up{};  ///< along both [mm/s2]
    std::array<double, 2> ramp_up{};   ///< how fast it begins, along both [mm/s3]
    /// Half of the segments along which an axis turns, infinite without: from there on hold_beside() counts.
    std::array<double, 2> held_from{};  // [mm]
    bool at_tip = false;
  };

  Courses still() const;
  void add_linear(const CurvePoint& at, std::span<const Series> angles, Courses& courses) const;
  std::vector<Series> angles_at(const std::array<double, 3>& angles, const std::array<double, 3>& slopes,
                                const std::array<double, 3>& second,
                                const std::array<double, 3>& third) const;
  double speed_up(const CurvePoint& at, const SegmentTurn* turn) const;
  double ramp_up(const CurvePoint& at, const SegmentTurn* turn) const;
  TurnLimit rounded_limit(const Meeting& meeting, const Bend& bend, const TurnJoint& joint) const;
  double reach_for_bend(const Meeting& meeting, double step, double half, double acceleration) const;
  double speed_for_velocity(const Meeting& meeting, std::size_t i, double step, double half,
                            double velocity) const;
  TurnLimit jump_limit(const Meeting& meeting, const std::array<double, 3>& step) const;
  double tilt_at(const std::array<double, 3>& angles) const;
  /// Of the orientation where segment `segment` meets the next one: the tighter of the two [rad].
  double tolerance_at(const Toolpath& path, std::size_t segment) const;

  const Machine& machine_;
  const KinematicChain& chain_;
  std::vector<const RotaryAxis*> axes_;
  PartOnMachine part_;
  double tolerance_ = 0;         ///< of the orientation where the program gives none [rad]
  bool follows_program_ = true;  ///< it may give one: OTOL, CYCLE832, TA of cycle 32 and of M128
  double period_ = 0;            ///< [s]
};

/// How far the rotary axis with this step is from its programmed angle beside a joint [rad], with the
/// derivatives of that by the path; `away` from the joint along the path, negative (-0.0 too) before it [mm].
Series joint_turn(double step, double half, double away);

}  // namespace feedscope
