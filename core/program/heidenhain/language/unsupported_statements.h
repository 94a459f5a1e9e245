#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/program/heidenhain/context.h"

namespace feedscope::heidenhain {

/// Reports known but unsupported statements, once each, and unknown ones.
class UnsupportedStatements : private Part {
 public:
  explicit UnsupportedStatements(Context& context) : Part(context) {}

  /// Returns false for a name that is not among them.
  bool report_known(std::string_view name, std::uint32_t column);
  void report_unknown(std::string_view statement, std::uint32_t column);

 private:
  std::vector<std::string_view> reported_;
};

}  // namespace feedscope::heidenhain
