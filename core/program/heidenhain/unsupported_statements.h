#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/program/heidenhain/context.h"

namespace feedscope::heidenhain {

/// Statements that are known and not supported, each reported once, and such that are not known at all.
class UnsupportedStatements : private Part {
 public:
  explicit UnsupportedStatements(Context& context) : Part(context) {}

  /// False for a name that is not among them.
  bool report_known(std::string_view name, std::uint32_t column);
  void report_unknown(std::string_view statement, std::uint32_t column);

 private:
  std::vector<std::string_view> reported_;
};

}  // namespace feedscope::heidenhain
