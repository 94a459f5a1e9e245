#include "core/program/iso/language/words.h"

#include <algorithm>
#include <bit>

namespace feedscope::iso {

void BlockWords::clear() {
  present = 0;
  groups.fill(nullptr);
  other_codes = false;
  own_words = false;
  exact_stop = false;
  stop = false;
  changes_unit = false;
  dwell = 0;
  macro_call = false;
  distance = nullptr;
  angle = nullptr;
  corner = nullptr;
  flow = nullptr;
  function_count = 0;
}

std::uint32_t BlockWords::first_column(Letters letters) const {
  std::uint32_t column = 0;
  for (std::uint32_t left = present & letters.mask; left != 0; left &= left - 1) {
    const std::uint32_t at = by_letter[static_cast<std::size_t>(std::countr_zero(left))].column;
    column = column == 0 ? at : std::min(column, at);
  }
  return column;
}

}  // namespace feedscope::iso
