#include "core/identification/identified_parameter.h"

#include <fmt/format.h>

namespace feedscope {

Provenance identified_source(const IdentifiedParameter& parameter, const std::string& from) {
  const std::string& unit = parameter.parameter.unit;
  return {fmt::format("identified from {}, {:.4g} ± {:.2g}{}{}", from, parameter.value, parameter.uncertainty,
                      unit.empty() ? "" : " ", unit),
          false};
}

Provenance untold_source(const IdentifiedParameter& parameter, const std::string& from) {
  return {parameter.at_least
              ? fmt::format("not told by {}: at least {:.4g} {}, this explains them as well as others", from,
                            *parameter.at_least, parameter.parameter.unit)
              : fmt::format("not told by {}: this explains them as well as others", from),
          true};
}

}  // namespace feedscope
