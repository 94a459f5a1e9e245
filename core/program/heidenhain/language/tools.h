#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/program/heidenhain/geometry/feeds.h"
#include "core/program/heidenhain/language/labels.h"
#include "core/program/tools/cutter_radii.h"

namespace feedscope::heidenhain {

struct ToolCall {
  std::optional<std::string> tool;
  std::optional<Plane> plane;   ///< across the tool axis
  std::optional<double> speed;  ///< [1/min]
  std::optional<double> feed;   ///< as written
  FeedWord feed_word = FeedWord::value;
  std::uint32_t feed_column = 0;
  double radius_excess = 0;  ///< DR [mm]
};

/// Tools: their definitions and calls, the side of the contour, the spindle.
class Tools : private Part {
 public:
  /// All outlive it.
  Tools(Context& context, const Labels& labels, Feeds& feeds)
      : Part(context), labels_(labels), feeds_(feeds) {}

  /// Reads a tool's number or name, as a key; none if none is next. Throws ReadFault.
  std::optional<std::string> read_name(Scanner& scanner) const;
  /// TOOL DEF; radius in mm.
  void define(const std::string& tool, double radius) { defined_radii_.set(tool, radius); }
  void call(const ToolCall& call);
  /// RL, RR, R0 of a block.
  void select_side(const MotionWords& words);
  /// M3, M4, M5 and the like; other M functions do nothing.
  void run_spindle(int m, std::uint32_t column);

  /// Number of the tool; none if it has only a name.
  std::optional<double> number() const;
  std::optional<double> radius_of(const std::string& tool) const;

 private:
  const Labels& labels_;
  Feeds& feeds_;
  CutterRadii defined_radii_;
};

}  // namespace feedscope::heidenhain
