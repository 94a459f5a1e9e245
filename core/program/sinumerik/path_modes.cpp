#include "core/program/sinumerik/path_modes.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/base/units.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

void PathModes::apply(std::string_view name) {
  path_words_.apply(name);
  applied_ = Applied::none;
}

bool PathModes::run(Scanner& scanner, std::string_view name, std::uint32_t column) {
  using Setter = void (PathWords::*)(double);
  constexpr auto setters =
      std::to_array<std::pair<std::string_view, Setter>>({{"ADIS", &PathWords::set_distance},
                                                          {"ADISPOS", &PathWords::set_rapid_distance},
                                                          {"CTOL", &PathWords::set_tolerance},
                                                          {"OTOL", &PathWords::set_orientation_tolerance}});
  for (const auto& [known, set] : setters) {
    if (!letters::same(name, known) || !scanner.take('=')) {
      continue;
    }
    const double value = values_.read(scanner);
    if (known.starts_with("ADIS") && value < 0) {
      throw ReadFault{"path-value", column, fmt::format("{}={} is negative", known, value),
                      "write a distance of zero or more; the block does not move"};
    }
    (path_words_.*set)(known == "OTOL" ? units::from_deg(value) : to_mm(value));
    applied_ = Applied::none;
    return true;
  }
  return false;
}

void PathModes::set_cycle(double tolerance, int code, std::optional<double> orientation) {
  path_words_.set_cycle(tolerance, code, orientation);
  applied_ = Applied::none;
}

void PathModes::use(bool rapid) {
  const bool exact_stop = functions_.exact_stop;
  const Applied wanted = exact_stop ? Applied::none : rapid ? Applied::rapid : Applied::feed;
  if (wanted == Applied::none || applied_ != wanted) {
    path().set_path_control(path_words_.control(rapid, exact_stop));
    applied_ = wanted;
  }
}

void PathModes::restore(const PathWords& words) {
  path_words_ = words;
  applied_ = Applied::none;
}

}  // namespace feedscope::sinumerik
