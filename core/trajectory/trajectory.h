#pragma once

#include <cstdint>
#include <vector>

#include "core/blend/blended_path.h"
#include "core/limits/cause.h"
#include "core/trajectory/filtered_motion.h"

namespace feedscope {

/// What q(t) of a piece counts.
enum class Law : std::uint8_t {
  path_length,  ///< path length from the element's start [mm]
  parameter,    ///< the blend's own parameter u
  filtered,     ///< path length; the motion is that of a FilteredMotion, q its value at the piece's start
};

/// Motion on (a part of) one path element: q(tau) = q + v tau + a tau^2/2 + j tau^3/6, tau = t - time.
/// A filtered piece uses q only.
struct Piece {
  double time = 0;  ///< start [s]; it ends where the next begins
  double q = 0;
  double v = 0;
  double a = 0;
  double j = 0;
  std::uint32_t element = 0;  ///< index into BlendedPath::elements
  Cause cause;
  Law law = Law::path_length;
};

/// Everything at one instant. Vectors by the chain rule from curve and law, nothing differenced.
struct State {
  double time = 0;                     ///< [s]
  double path_length = 0;              ///< executed, from the start [mm]
  Vec3 position;                       ///< [mm]
  Vec3 velocity;                       ///< [mm/s]
  Vec3 acceleration;                   ///< [mm/s2]
  Vec3 jerk;                           ///< [mm/s3]
  double speed = 0;                    ///< [mm/s]
  double tangential_acceleration = 0;  ///< dv/dt [mm/s2]
  double tangential_jerk = 0;          ///< d2v/dt2 [mm/s3]
  double programmed_feed = 0;          ///< [mm/s]; for a rapid the axes' speed along it
  std::uint32_t line = 0;              ///< source line
  std::uint32_t element = 0;           ///< index into BlendedPath::elements
  Cause cause;
};

/// One curve that the control put into a corner, a cubic blend or a connecting arc: ask its element which.
/// On filtered motion the part that the blending pulses of the corner make: `transition` the programmed
/// length of the longer one, `epsilon` by closest approach, `min_radius` there.
struct BlendRecord {
  std::uint32_t line = 0;     ///< of the block that ends at the corner
  std::uint32_t element = 0;  ///< index into BlendedPath::elements; filtered: the one that ends at the corner
  Vec3 corner;                ///< programmed [mm]
  double turn = 0;            ///< direction change [rad]
  double transition = 0;      ///< T, from the corner to the blend's ends [mm]
  double epsilon = 0;         ///< distance of the corner from the blend [mm]
  double length = 0;          ///< [mm]
  double min_radius = 0;      ///< [mm]
  double entry_speed = 0;     ///< [mm/s]
  double exit_speed = 0;      ///< [mm/s]
};

/// What a control model says the machine does: executed path and time law as exact pieces.
class Trajectory {
 public:
  Trajectory() = default;
  /// `blends` in the order of their elements, entry and exit speed filled in here but for filtered motion.
  /// `lines`, `feeds` [mm/s]: per path element, source line and programmed feed (axes' speed for a rapid).
  Trajectory(BlendedPath path, std::vector<Piece> pieces, double duration, std::vector<BlendRecord> blends,
             std::vector<std::uint32_t> lines, std::vector<double> feeds, std::vector<bool> rapid,
             double compaction_error = 0, std::vector<FilteredMotion> motions = {});

  double duration() const { return duration_; }          ///< cycle time [s]
  double path_length() const { return path_.length(); }  ///< executed [mm]
  const BlendedPath& path() const { return path_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<BlendRecord>& blends() const { return blends_; }
  /// Largest distance of a programmed point that the control leaves out from the executed path [mm].
  double compaction_error() const { return compaction_error_; }
  const std::vector<FilteredMotion>& motions() const { return motions_; }

  /// State at a time, clamped to [0, duration]. At a piece border: the piece that begins there.
  /// An empty trajectory gives a State at the origin, at rest.
  State state(double time) const;
  /// State at the first instant at which the path length is `s`, clamped to [0, path_length()].
  State state_at_path(double s) const;
  /// State in a known piece at `tau` from its start; for callers that walk the pieces in order.
  State state_in_piece(std::size_t piece, double tau) const;
  Kinematics kinematics_in_piece(std::size_t piece, double tau) const;
  std::size_t piece_at(double time) const;
  double piece_end(std::size_t piece) const;  ///< [s]
  /// Into how many equal parts a filtered piece is to be cut so that each lasts at most 1/`a_filter_time` of
  /// the filter time; 1 where its velocity is constant.
  int filtered_spans(std::size_t piece, double a_filter_time) const;
  double piece_length(std::size_t piece) const;  ///< path length of a filtered piece [mm]

  std::uint32_t line_of(std::size_t element) const { return lines_[element]; }
  double feed_of(std::size_t element) const { return feeds_[element]; }  ///< [mm/s]
  bool is_rapid(std::size_t element) const { return rapid_[element]; }
  /// First instant at which the block of `line`, or of the nearest later line that moves, is under way.
  double time_of_line(std::uint32_t line) const;

 private:
  void fill_blend_speeds();

  CurvePoint curve_point(const Piece& piece, double q) const;
  const FilteredMotion& motion_of(const Piece& piece) const;
  State filtered_state(State state, const Piece& piece, double tau) const;

  BlendedPath path_;
  std::vector<Piece> pieces_;
  double duration_ = 0;
  std::vector<BlendRecord> blends_;
  std::vector<std::uint32_t> lines_;
  std::vector<double> feeds_;
  std::vector<bool> rapid_;
  double compaction_error_ = 0;
  std::vector<FilteredMotion> motions_;
};

}  // namespace feedscope
