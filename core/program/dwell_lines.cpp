#include "core/program/dwell_lines.h"

#include <fmt/format.h>

namespace feedscope {

std::vector<std::string> dwell_lines(Dialect dialect, double time) {
  switch (dialect) {
    case Dialect::heidenhain:
      return {"CYCL DEF 9.0 DWELL TIME", fmt::format("CYCL DEF 9.1 DWELL {}", time)};
    case Dialect::heidenhain_iso:
      return {fmt::format("G04 F{}", time)};
    case Dialect::sinumerik:
      return {fmt::format("G4 F{}", time)};
    case Dialect::fanuc:
      return {fmt::format("G4 X{}", time)};
    default:
      return {fmt::format("G4 P{}", time)};
  }
}

}  // namespace feedscope
