#pragma once

#include <string>
#include <utility>

#include "core/machine/settings.h"

namespace feedscope {

/// Specification of an axis limit; its bounds are far beyond any machine, and beyond them the units of the
/// models would overflow.
inline SettingSpec limit_spec(std::string key, std::string title, std::string unit, std::string explanation) {
  return {
      .key = std::move(key),
      .title = std::move(title),
      .unit = std::move(unit),
      .explanation = std::move(explanation),
      .minimum = 1e-6,
      .maximum = 1e9,
  };
}

}  // namespace feedscope
