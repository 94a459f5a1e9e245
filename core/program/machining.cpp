#include "core/program/machining.h"

namespace feedscope {

void Machining::report(const ReadFault& fault) const {
  report(Severity::error, fault.code, 0, fault.column, [&] { return Text{fault.message, fault.hint}; });
}

void Machining::report_machine_move(std::string_view what, MessageCode code, std::uint32_t column) const {
  report(Severity::warning, code, 0, column, [&] {
    return Text{
        message(NC_("core", "{} moves to a machine position, which the program does not contain"), what),
        NC_("core",
            "neither drawn nor timed unless the machine gives positions (home_z_mm, part_zero_z_mm, ...); "
            "the path continues where every axis is programmed again")};
  });
}

std::optional<Vec3> Machining::tool_direction(const Vec3& vector, const Message& words,
                                              std::string_view example, std::uint32_t column) const {
  if (!(vector.norm() > 0)) {
    report(Severity::error, "rotary-direction", 0, column, [&] {
      return Text{
          message(NC_("core", "{} are all zero: the tool has no direction"), words),
          message(
              NC_("core", "the rotary axes stay; write the vector from the tip to the spindle, such as {}"),
              example)};
    });
    return std::nullopt;
  }
  return path.frame().turned(vector.normalized()).normalized();
}

}  // namespace feedscope
