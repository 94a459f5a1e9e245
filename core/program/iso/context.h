#pragma once

#include <string_view>

#include "core/program/iso/expression.h"
#include "core/program/iso/modal_state.h"
#include "core/program/iso/words.h"
#include "core/program/machining.h"

namespace feedscope::iso {

/// What all parts of the reader work on: the words of the block in force and what stays in force from block
/// to block.
struct Context {
  Machining& machining;
  Dialect dialect = Dialect::iso;
  BlockWords words = {};
  ModalState modal = {};
};

/// What the parts of the reader have in common: short names for what they work on.
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
  /// True, and reported, if the block has no word `letter`, which G word `g` needs; `effect` says what
  /// happens without it.
  bool lacks(MessageCode code, char letter, int g, std::uint32_t column, Translatable effect) const;

  BlockWords& words_;
  ModalState& modal_;
  Machining& machining_;

 private:
  const Context& context_;
};

}  // namespace feedscope::iso
