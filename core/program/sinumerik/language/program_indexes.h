#pragma once

#include <map>

#include "core/program/sinumerik/language/program_index.h"

namespace feedscope::sinumerik {

/// The index of each text that runs, created once.
class ProgramIndexes {
 public:
  /// Valid as long as this; `text` outlives it.
  const ProgramIndex& of(const SourceText& text) {
    const auto found = indexes_.find(&text);
    return found != indexes_.end() ? found->second
                                   : indexes_.emplace(&text, ProgramIndex(text)).first->second;
  }

 private:
  std::map<const SourceText*, ProgramIndex> indexes_;
};

}  // namespace feedscope::sinumerik
