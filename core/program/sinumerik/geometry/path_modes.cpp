#include "core/program/sinumerik/geometry/path_modes.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/base/units.h"
#include "core/machine/contour_tolerance.h"
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
      throw ReadFault{"path-value", column, message(NC_("core", "{}={} is negative"), known, value),
                      NC_("core", "write a distance of zero or more; the block does not move")};
    }
    if (known == "OTOL") {
      path_words_.set_orientation_tolerance(units::from_deg(value));
    } else {
      (path_words_.*set)(simulated(
          to_mm(value), Message::as_written(fmt::format("{}={}", known, plain_text(value))), column));
    }
    applied_ = Applied::none;
    return true;
  }
  return false;
}

void PathModes::set_cycle(double tolerance, int code, std::optional<double> orientation,
                          std::uint32_t column) {
  const Message words =
      message(NC_("core", "tolerance {} mm of CYCLE832"), Message::number(plain_text(tolerance)));
  path_words_.set_cycle(simulated(tolerance, words, column), code, orientation);
  applied_ = Applied::none;
}

double PathModes::simulated(double tolerance, const Message& words, std::uint32_t column) const {
  if (!is_too_small(tolerance)) {
    return tolerance;
  }
  report(Severity::warning, "path-value", 2, column, [&] { return too_small_text(words); });
  return least_tolerance;
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
