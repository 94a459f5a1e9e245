#pragma once

#include <cstdint>
#include <string_view>

#include "core/program/heidenhain/geometry/contour_writer.h"
#include "core/program/heidenhain/language/q_parameters.h"
#include "core/program/heidenhain/language/statement_lines.h"
#include "core/program/heidenhain/modal_state.h"
#include "core/program/machining.h"

namespace feedscope::heidenhain {

/// Shared state of all parts of the readers: the current statement, modal state, the contour and the Q
/// parameters.
struct Context {
  /// `machining` outlives it.
  Context(Machining& machining, Dialect dialect);
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  Machining& machining;
  Dialect dialect;  ///< required of called programs, too
  StatementLines statement;
  ModalState modal;
  ContourWriter contour;
  QParameters parameters;
  QFormulas formulas;

  /// G70 and G71, INCH and MM.
  void set_inch(bool inch);

  /// Reports at a column of the current statement; 0: the statement as a whole.
  template <typename MakeText>
  void report(Severity severity, MessageCode code, int detail, std::uint32_t column, MakeText&& text) const {
    machining.log.add(severity, code, detail, statement.place(column), text);
  }

 private:
  /// The value of a parameter that the program has not set.
  double unset_value(const QName& name);
  void use_tool_radius();
};

/// Throws ReadFault "unread-word" about the rest of the statement, which does not belong in `where`.
[[noreturn]] void throw_unread_words(Scanner& scanner, const Message& where);

/// Short names for the shared state, for the parts of the readers.
class Part {
 protected:
  using Text = DiagnosticLog::Text;

  /// `context` outlives it.
  explicit Part(Context& context)
      : context_(context), modal_(context.modal), contour_(context.contour), machining_(context.machining) {}

  PathWriter& path() const { return machining_.path; }
  LineRunner& lines() const { return machining_.lines; }
  QParameters& parameters() const { return context_.parameters; }
  /// The working plane.
  Plane plane() const { return contour_.plane(); }

  double to_mm(double value) const { return modal_.to_mm(value); }
  /// A number or a parameter, as QFormulas::read_value(). Throws ReadFault.
  double read_value(Scanner& scanner) const { return context_.formulas.read_value(scanner); }
  double read_length(Scanner& scanner) const { return to_mm(read_value(scanner)); }

  template <typename MakeText>
  void report(Severity severity, MessageCode code, int detail, std::uint32_t column, MakeText&& text) const {
    context_.report(severity, code, detail, column, text);
  }
  BlockPlace contour_place(std::uint32_t column, std::uint8_t axes) const;
  /// Writes everything pending and assigns the next elements to this line.
  void end_contour(std::uint32_t column) const;

  Context& context_;
  ModalState& modal_;
  ContourWriter& contour_;
  Machining& machining_;
};

}  // namespace feedscope::heidenhain
