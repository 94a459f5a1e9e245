#include "core/identification/identified_parameter.h"

#include <fmt/format.h>

#include <string_view>

#include "core/machine/undetermined.h"

namespace feedscope {
namespace {

constexpr const char* kept_from = "kept from before: ";

}  // namespace

Provenance identified_source(const IdentifiedParameter& parameter, const std::string& from) {
  const std::string& unit = parameter.parameter.unit;
  return {fmt::format("identified from {}, {:.4g} ± {:.2g}{}{}", from, parameter.value, parameter.uncertainty,
                      unit.empty() ? "" : " ", unit),
          false};
}

Provenance undetermined_source(const IdentifiedParameter& parameter, const std::string& from,
                               const Provenance& before) {
  std::string text = fmt::format("{}{}: ", undetermined_by, from);
  if (parameter.at_least) {
    text += fmt::format("at least {:.4g} {}, ", *parameter.at_least, parameter.parameter.unit);
  }
  if (parameter.value != parameter.start) {
    return {text + "this explains them as well as others", true};
  }
  const auto kept = before.source.find(kept_from);  // of an earlier identification
  const std::string origin = kept == std::string::npos
                                 ? before.source
                                 : before.source.substr(kept + std::string_view(kept_from).size());
  return {text + kept_from + origin, true};
}

}  // namespace feedscope
