#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/program/text/scanner.h"

namespace feedscope {

/// A statement and the method of the part that runs it, called after its name was read.
template <typename PartType, typename... Args>
using StatementEntry = std::pair<std::string_view, void (PartType::*)(Scanner&, Args...)>;

/// Makes `part` run the statement `name`, in upper or lower case; false if it is not in the table.
template <typename PartType, std::size_t count, typename... Args>
bool run_statement(PartType& part, const std::array<StatementEntry<PartType, Args...>, count>& table,
                   std::string_view name, Scanner& scanner, Args... args) {
  const auto* const found = std::find_if(
      table.begin(), table.end(),
      [&](const StatementEntry<PartType, Args...>& entry) { return letters::same(entry.first, name); });
  if (found == table.end()) {
    return false;
  }
  (part.*found->second)(scanner, args...);
  return true;
}

}  // namespace feedscope
