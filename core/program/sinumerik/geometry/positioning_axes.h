#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/last_motion.h"
#include "core/program/sinumerik/geometry/path_modes.h"
#include "core/program/sinumerik/geometry/splines.h"
#include "core/program/sinumerik/geometry/targets.h"
#include "core/program/sinumerik/language/values.h"

namespace feedscope::sinumerik {

/// Axes that move on their own, not along the path: POS, POSA, and FA, their feed.
class PositioningAxes : private Part {
 public:
  /// All outlive it.
  PositioningAxes(Context& context, Values& values, Targets& targets, Splines& splines, PathModes& path_modes,
                  LastMotion& last)
      : Part(context),
        values_(values),
        targets_(targets),
        splines_(splines),
        path_modes_(path_modes),
        last_(last) {}

  /// Forgets the positions of the previous block.
  void begin_block();
  /// Reads the value of `name`, which has just been read, if it is POS, POSA or FA; else returns false.
  /// Throws ReadFault.
  bool run(std::string_view name, Scanner& scanner);

  /// True if the block positions X, Y or Z.
  bool has_positions() const { return has_positions_; }
  /// Moves them; `path_moves`: the block also moves along the path, which is not supported.
  void move(bool path_moves);

  using AxisFeeds = std::array<double, 3>;  ///< FA by axis [mm/s]; 0: none
  const AxisFeeds& feeds() const { return feeds_; }
  void restore(const AxisFeeds& feeds) { feeds_ = feeds; }

 private:
  void read_position(Scanner& scanner);
  void read_feed(Scanner& scanner);
  void move_to(const Vec3& target, double feed, std::uint32_t column);

  Values& values_;
  Targets& targets_;
  Splines& splines_;
  PathModes& path_modes_;
  LastMotion& last_;
  std::array<std::optional<BlockWords::Value>, 3> positions_;
  bool has_positions_ = false;
  AxisFeeds feeds_{};
};

}  // namespace feedscope::sinumerik
