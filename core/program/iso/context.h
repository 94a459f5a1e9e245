#pragma once

#include <string_view>

#include "core/program/iso/language/expression.h"
#include "core/program/iso/language/words.h"
#include "core/program/iso/modal_state.h"
#include "core/program/machining.h"

namespace feedscope::iso {

/// Shared state of all parts of the reader: the words of the current block and the modal state.
struct Context {
  Machining& machining;
  Dialect dialect = Dialect::iso;
  BlockWords words = {};
  ModalState modal = {};
};

/// Short names for the shared state, for the parts of the reader.
class Part {
 protected:
  using Text = DiagnosticLog::Text;

  /// `context` outlives it.
  explicit Part(Context& context)
      : words_(context.words), modal_(context.modal), machining_(context.machining), context_(context) {}

  PathWriter& path() const { return machining_.path; }
  LineRunner& lines() const { return machining_.lines; }
  Dialect dialect() const { return context_.dialect; }
  bool is_linuxcnc() const { return follows_linuxcnc(context_.dialect); }

  /// Length of a word of the block [mm].
  double length(char letter) const { return modal_.to_mm(words_[letter].value); }
  double length_or(char letter, double otherwise) const {
    return words_.has(letter) ? length(letter) : otherwise;
  }

  template <typename MakeText>
  void report(Severity severity, MessageCode code, int detail, std::uint32_t column, MakeText&& text) const {
    machining_.report(severity, code, detail, column, text);
  }
  /// Returns true, with a report, if the block lacks word `letter`, which G word `g` needs; `effect`
  /// describes the consequence.
  bool lacks(MessageCode code, char letter, int g, std::uint32_t column, Translatable effect) const;

  BlockWords& words_;
  ModalState& modal_;
  Machining& machining_;

 private:
  const Context& context_;
};

}  // namespace feedscope::iso
