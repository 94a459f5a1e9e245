#include "core/machine/import/numbered_parameters.h"

namespace feedscope {

void NumberedParameters::add(int number, int axis, Entry entry, MachineDraft& draft) {
  const auto [before, is_first] = entries_.try_emplace({number, axis}, entry);
  if (is_first) {
    return;
  }
  if (before->second.value != entry.value) {
    draft.note(Severity::warning, entry.given.place, "given-twice",
               message(NC_("core", "{}, but {} in {}; {} is used"), entry.given.what, before->second.value,
                       draft.place_text(before->second.given.place), entry.value),
               NC_("core", "remove one of the two"));
  }
  before->second = std::move(entry);
}

const NumberedParameters::Entry* NumberedParameters::find(int number, int axis) const {
  const auto found = entries_.find({number, axis});
  return found == entries_.end() ? nullptr : &found->second;
}

bool NumberedParameters::has(int number) const {
  const auto first = entries_.lower_bound({number, no_axis});
  return first != entries_.end() && first->first.first == number;
}

}  // namespace feedscope
