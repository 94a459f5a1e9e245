#pragma once

#include <string_view>

#include "core/machine/machine.h"

namespace feedscope {

/// What `assumed` of a number begins with that recordings were searched for and do not determine; the names
/// of the recordings follow. So a machine file lists them: identification writes it, a run whose time such a
/// number limits says so.
inline constexpr std::string_view undetermined_by = "not determined by ";

inline bool is_undetermined(const Provenance& provenance) {
  return provenance.assumed && provenance.source.starts_with(undetermined_by);
}

}  // namespace feedscope
