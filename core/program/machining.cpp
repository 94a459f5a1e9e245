#include "core/program/machining.h"

#include <fmt/format.h>

namespace feedscope {

void Machining::report(const ReadFault& fault) const {
  report(Severity::error, fault.code, 0, fault.column, [&] { return Text{fault.message, fault.hint}; });
}

void Machining::report_machine_move(std::string_view what, MessageCode code, std::uint32_t column) const {
  report(Severity::warning, code, 0, column, [&] {
    return Text{
        fmt::format("{} moves to a machine position, which the program does not contain", what),
        "neither drawn nor timed unless the machine gives positions (home_z_mm, part_zero_z_mm, ...); the "
        "path continues where every axis is programmed again"};
  });
}

}  // namespace feedscope
