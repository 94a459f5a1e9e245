#include "core/program/heidenhain/context.h"

#include "core/base/units.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

Context::Context(Machining& machining_in, Dialect dialect_in)
    : machining(machining_in),
      dialect(dialect_in),
      statement(machining.lines),
      contour(machining.path, machining.log),
      formulas(parameters, [this](const QName& name) { return unset_value(name); }) {
  modal.unit = machining.unit.first() == LengthUnit::inch ? units::from_inch(1) : 1;
}

void Context::set_inch(bool inch) {
  modal.unit = inch ? units::from_inch(1) : 1;
  machining.unit.set(inch ? LengthUnit::inch : LengthUnit::mm);
}

/// Records that the path depends on the radius of the called tool, Q108.
void Context::use_tool_radius() {
  const bool is_from_outside = machining.tools.radius_of(modal.tool, std::nullopt) == modal.tool_radius;
  machining.tools.use_radius_of(modal.tool, is_from_outside ? std::nullopt : modal.tool_radius);
}

double Context::unset_value(const QName& name) {
  constexpr int tool_radius = 108;
  constexpr int tool_axis = 109;
  constexpr int unit = 113;
  constexpr int first_rotary_axis = 120;
  constexpr int last_rotary_axis = 122;
  if (name.kind == QName::Kind::global) {
    switch (name.number) {
      case tool_radius:
        use_tool_radius();
        if (modal.tool_radius) {
          return *modal.tool_radius / modal.unit;
        }
        break;
      case tool_axis:
        return normal_axis(contour.plane());
      case unit:
        return modal.is_inch() ? 1 : 0;
      default:
        break;
    }
  }
  if (name.kind == QName::Kind::global && name.number >= first_rotary_axis &&
      name.number <= last_rotary_axis) {
    modal.calculated_angles = true;
    if (machining.other_axes.turns()) {
      return 0;  // the axes turn to the plane
    }
    report(Severity::info, "unset-parameter", name.number, name.column, [&] {
      return DiagnosticLog::Text{
          message(
              NC_("core", "{} is the angle of a rotary axis that the control calculates for a tilted plane"),
              name.text()),
          NC_("core", "0 is used; X, Y and Z are shown in the tilted plane")};
    });
    return 0;
  }
  if (name.kind == QName::Kind::global && name.number == tool_radius) {
    report(Severity::warning, "unset-parameter", name.number, name.column, [&] {
      return DiagnosticLog::Text{
          NC_("core", "the tool radius Q108 is not known"),
          message(NC_("core",
                      "0 is used; give it as an import option (--tool {}=RADIUS) or in a tool table, or "
                      "write a TOOL DEF with R before the tool call"),
                  CutterRadii::key(modal.tool))};
    });
    return 0;
  }
  report(Severity::warning, "unset-parameter", static_cast<int>(name.kind) * 10000 + name.number, name.column,
         [&] {
           return DiagnosticLog::Text{
               message(NC_("core", "{} has no value"), name.text()),
               NC_("core", "0 is used; the control may still have another value, assign one first")};
         });
  return 0;
}

void throw_unread_words(Scanner& scanner, const Message& where) {
  const std::uint32_t column = scanner.column();
  throw ReadFault{"unread-word", column,
                  message(NC_("core", "{} is not valid in {}"), in_quotes(scanner.rest()), where),
                  NC_("core", "the block is skipped; correct it")};
}

BlockPlace Part::contour_place(std::uint32_t column, std::uint8_t axes) const {
  const StatementLines& statement = context_.statement;
  return {lines().shown_line(), statement.is_joined() ? statement.place(column) : lines().place(column), axes,
          0};
}

void Part::end_contour(std::uint32_t column) const {
  contour_.flush();
  path().begin_line(lines().shown_line(), context_.statement.place(column));
}

}  // namespace feedscope::heidenhain
