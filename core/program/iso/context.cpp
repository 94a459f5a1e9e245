#include "core/program/iso/context.h"

#include <fmt/format.h>

#include "core/program/text/message.h"

namespace feedscope::iso {

bool Part::lacks(MessageCode code, char letter, int g, std::uint32_t column, std::string_view effect) const {
  if (words_.has(letter)) {
    return false;
  }
  report(Severity::error, code, letter, column, [&] {
    return Text{fmt::format("{} without {}", g_name(g), letter), std::string(effect)};
  });
  return true;
}

}  // namespace feedscope::iso
