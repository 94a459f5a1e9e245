#pragma once

#include <map>
#include <optional>
#include <utility>

#include "core/machine/import/machine_draft.h"

namespace feedscope {

/// Parameters of a control by number and axis, as read.
class NumberedParameters {
 public:
  struct Entry {
    double value = 0;
    GivenValue given;
  };
  static constexpr int no_axis = -1;

  /// A later entry replaces an earlier one; a different value adds a note to the draft.
  void add(int number, int axis, Entry entry, MachineDraft& draft);
  /// Null if there is none.
  const Entry* find(int number, int axis = no_axis) const;
  bool has(int number) const;

 private:
  std::map<std::pair<int, int>, Entry> entries_;
};

}  // namespace feedscope
