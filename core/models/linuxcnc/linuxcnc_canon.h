#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/limits/axis_share.h"
#include "core/models/linuxcnc/linuxcnc_segment.h"
#include "core/models/linuxcnc/linuxcnc_words.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// A message from LinuxCNC's interpreter.
struct LinuxCncMessage {
  enum class Kind : std::uint8_t {
    move,
    mode,   ///< G64 or G61 changes
    wait,   ///< until all motion has ended
    dwell,  ///< the same, then `time`
    pause,  ///< a pause of the path without a time; its command has waited already
  };
  Kind kind = Kind::move;
  LinuxCncSegment move;
  double time = 0;          ///< [s]
  std::uint32_t block = 0;  ///< of the toolpath
};

/// Limits of moves, and the joining of short blocks (README.md, "Canon").
class LinuxCncCanon {
 public:
  LinuxCncCanon(const Toolpath& toolpath, const LinuxCncSettings& settings);
  /// Returns the next message; none at the end of the program.
  std::optional<LinuxCncMessage> next();

 private:
  struct Mode {
    LinuxCncEnd end = LinuxCncEnd::parabolic;  ///< of G64, else exact or stop
    double tolerance = 0;                      ///< [mm]
    double naive = 0;                          ///< [mm]
    bool blends() const { return end == LinuxCncEnd::parabolic; }
    bool operator==(const Mode&) const = default;
  };
  struct Point {
    Vec3 place;
    std::uint32_t block;
  };

  void read_block(std::size_t block);
  Mode mode_of(std::size_t block) const;
  Mode mode_of_settings() const;
  void enter_mode(const Mode& mode, std::uint32_t block);
  void line(std::size_t block);
  void arc(std::size_t block);
  void collect(const Vec3& end, std::uint32_t block, double feed);
  bool linkable(const Vec3& end) const;
  void flush();
  void lower_by_turn(std::uint32_t block, LinuxCncSegment& move, AxisBound& velocity,
                     AxisBound& acceleration) const;
  void send_line(const Vec3& from, const Vec3& to, double feed, bool rapid, std::uint32_t block);
  void send(LinuxCncMessage::Kind kind, std::uint32_t block, double time = 0);

  const Toolpath& toolpath_;
  LinuxCncSettings settings_;
  LinuxCncWaits waits_;
  std::size_t block_ = 0;             ///< to be read next
  std::deque<LinuxCncMessage> sent_;  ///< but not yet taken
  std::vector<Point> chain_;
  Vec3 chain_start_ = Vec3::Zero();
  double chain_feed_ = 0;
  Mode mode_;
  bool spindle_starts_ = false;
};

}  // namespace feedscope
