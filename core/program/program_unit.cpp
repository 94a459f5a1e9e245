#include "core/program/program_unit.h"

#include "core/base/units.h"

namespace feedscope {

std::string_view to_string(LengthUnit unit) {
  return unit == LengthUnit::inch ? "inch" : "mm";
}

Message describe(const ProgramUnit& unit) {
  const Message length = unit.unit == LengthUnit::inch ? NC_("core", "inch") : Message::as_written("mm");
  switch (unit.source) {
    case ProgramUnit::Source::program:
      return message(NC_("core", "{}, by the program"), length);
    case ProgramUnit::Source::asked:
      return message(NC_("core", "{}, by --unit"), length);
    default:
      return message(NC_("core", "{}, assumed: the program does not define its unit"), length);
  }
}

bool looks_like_inches(const CutSize& cut) {
  constexpr double largest_size = 50;   // [mm]; in an inch program 1.3 m
  constexpr double largest_feed = 300;  // [mm/min]; in an inch program 7.6 m/min
  const double size = cut.size.maxCoeff();
  const double feed = units::to_mm_min(cut.feed);
  return size > 0 && size <= largest_size && feed > 0 && feed <= largest_feed;
}

}  // namespace feedscope
