#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/program/machining.h"
#include "core/program/sinumerik/language/macros.h"
#include "core/program/sinumerik/language/words.h"
#include "core/program/sinumerik/modal_state.h"

namespace feedscope::sinumerik {

/// Shared state of all parts of the reader: the words of the current block and the modal state.
struct Context {
  Machining& machining;
  BlockWords words = {};
  BlockFunctions functions = {};
  ModalState modal = {};
  std::optional<Macros::Line> replaced = std::nullopt;  ///< the current line, if it has macros

  /// Column in the line as written; `column` is one of the line with its macros replaced.
  std::uint32_t written(std::uint32_t column) const {
    return replaced ? replaced->written_column(column) : column;
  }
};

/// Short names for the shared state, for the parts of the reader.
class Part {
 protected:
  using Text = DiagnosticLog::Text;

  /// `context` outlives it.
  explicit Part(Context& context)
      : words_(context.words),
        functions_(context.functions),
        modal_(context.modal),
        machining_(context.machining),
        context_(context) {}

  PathWriter& path() const { return machining_.path; }
  LineRunner& lines() const { return machining_.lines; }
  double to_mm(double value) const { return modal_.to_mm(value); }

  std::uint32_t written(std::uint32_t column) const { return context_.written(column); }
  DiagnosticLog::Place place(std::uint32_t column) const { return lines().place(written(column)); }
  template <typename MakeText>
  void report(Severity severity, MessageCode code, int detail, std::uint32_t column, MakeText&& text) const {
    machining_.report(severity, code, detail, written(column), text);
  }

  BlockWords& words_;
  BlockFunctions& functions_;
  ModalState& modal_;
  Machining& machining_;

 private:
  const Context& context_;
};

}  // namespace feedscope::sinumerik
