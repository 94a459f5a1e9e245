#pragma once

#include <cstdint>
#include <optional>

#include "core/program/heidenhain/geometry/coordinates.h"
#include "core/program/heidenhain/geometry/targets.h"
#include "core/program/heidenhain/language/tools.h"

namespace feedscope::heidenhain {

/// FN 18: values of the control.
class SystemData : private Part {
 public:
  /// All outlive it.
  SystemData(Context& context, const Tools& tools, const Targets& targets, const Coordinates& coordinates)
      : Part(context), tools_(tools), targets_(targets), coordinates_(coordinates) {}

  /// Reads from "SYSREAD" on. Throws ReadFault.
  void read(Scanner& scanner, std::uint32_t column);

 private:
  void assign(const QName& result, double group, double number, double index, std::uint32_t column);
  /// Empty where only the machine knows the value.
  std::optional<double> value(double group, double number, double index) const;

  const Tools& tools_;
  const Targets& targets_;
  const Coordinates& coordinates_;
};

}  // namespace feedscope::heidenhain
