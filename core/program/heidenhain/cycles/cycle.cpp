#include "core/program/heidenhain/cycles/cycle.h"

namespace feedscope::heidenhain {

namespace {

Translatable text_of(DrillingFault fault) {
  switch (fault) {
    case DrillingFault::none:
      break;
    case DrillingFault::depth:
      return NC_("core", "its depth Q201 is above the surface; write it negative");
    case DrillingFault::by_diameter:
      return NC_("core", "centring to a diameter needs the tool's point angle; write Q343=0 and the depth");
    case DrillingFault::tool_radius:
      return NC_("core", "the radius of the tool is not known; write a TOOL DEF with R before the tool call");
    case DrillingFault::pitch:
      return NC_("core", "it has no pitch or the spindle no speed; write S in the tool call");
    case DrillingFault::steps:
      return NC_("core",
                 "it would take more than 10000 infeeds, or its infeeds are negative; check Q202 and the "
                 "other infeeds");
    case DrillingFault::infeeds:
      return NC_("core", "several infeeds (Q202 below its depth) are not supported; write Q202=0 for one");
    case DrillingFault::counterbore:
      return NC_("core", "its depth Q249 is not above zero; write it positive");
    case DrillingFault::direction:
      return NC_("core", "the direction Q214 in which the tool passes the hole is not 1 to 4");
  }
  return {};
}

}  // namespace

DrillingPlace drilling_place(const Context& context) {
  const ModalState& modal = context.modal;
  return {context.machining.path, context.contour.plane(), modal.spindle_speed / 60, modal.tool_radius};
}

void report_fault(const Context& context, int number, DrillingFault fault, std::uint32_t column) {
  if (fault != DrillingFault::none) {
    context.report(Severity::error, "cycle-value", number * 10 + static_cast<int>(fault), column, [&] {
      return DiagnosticLog::Text{message(NC_("core", "cycle {} is not executed: {}"), number, text_of(fault)),
                                 NC_("core", "its motion is skipped")};
    });
  }
}

}  // namespace feedscope::heidenhain
