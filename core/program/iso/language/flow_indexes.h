#pragma once

#include <map>

#include "core/program/iso/language/flow_index.h"

namespace feedscope::iso {

/// The flow index of each text that runs, created once.
class FlowIndexes {
 public:
  explicit FlowIndexes(bool skip_deleted) : skip_deleted_(skip_deleted) {}

  /// Valid as long as this; `text` outlives it.
  const FlowIndex& of(const SourceText& text) {
    const auto found = indexes_.find(&text);
    return found != indexes_.end() ? found->second
                                   : indexes_.emplace(&text, FlowIndex(text, skip_deleted_)).first->second;
  }

 private:
  bool skip_deleted_;
  std::map<const SourceText*, FlowIndex> indexes_;
};

}  // namespace feedscope::iso
