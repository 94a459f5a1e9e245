#pragma once

#include <optional>

#include "core/program/heidenhain/context.h"

namespace feedscope::heidenhain {

/// Feed in force, set by F words of blocks and of tool calls.
class Feeds : private Part {
 public:
  explicit Feeds(Context& context) : Part(context) {}

  /// Applies the F of a block, if it has one.
  void apply(const MotionWords& words);
  /// Applies the F of a tool call; valid until another F (TNC 426/430 user's manual, 5.2 Tool Data).
  void apply_tool_call(FeedWord word, double feed, std::uint32_t column);
  /// M136 and M137.
  void set_per_revolution(bool per_revolution);
  /// Feed of a block with these words.
  ContourFeed of(const MotionWords& words) const;
  /// Feed that applies to this block alone; none if it has none.
  std::optional<ContourFeed> alone(const MotionWords& words);

 private:
  void report_value(const MotionWords& words) const;

  bool per_revolution_ = false;
};

}  // namespace feedscope::heidenhain
