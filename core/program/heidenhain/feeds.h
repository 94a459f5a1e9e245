#pragma once

#include <optional>

#include "core/program/heidenhain/context.h"

namespace feedscope::heidenhain {

/// The feed in force, by F words of blocks and of tool calls.
class Feeds : private Part {
 public:
  explicit Feeds(Context& context) : Part(context) {}

  /// F of a block, if it has one.
  void apply(const MotionWords& words);
  /// F of a tool call; it holds until another F (TNC 426/430 user's manual, 5.2 Tool Data).
  void apply_tool_call(FeedWord word, double feed, std::uint32_t column);
  /// M136 and M137.
  void set_per_revolution(bool per_revolution);
  /// What a block with these words moves at.
  ContourFeed of(const MotionWords& words) const;
  /// Of a block whose feed holds for it alone; none if it has none.
  std::optional<ContourFeed> alone(const MotionWords& words);

 private:
  void report_value(const MotionWords& words) const;

  bool per_revolution_ = false;
};

}  // namespace feedscope::heidenhain
