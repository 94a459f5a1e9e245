#pragma once

#include <string_view>

#include "core/machine/machine.h"

namespace feedscope {

/// Prefix of `assumed` for a number that recordings were searched for but do not determine; the names of the
/// recordings follow. Identification writes it into a machine file; a run whose time such a number limits
/// reports it.
inline constexpr std::string_view undetermined_by = "not determined by ";

inline bool is_undetermined(const Provenance& provenance) {
  return provenance.assumed && provenance.source.starts_with(undetermined_by);
}

}  // namespace feedscope
