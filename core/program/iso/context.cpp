#include "core/program/iso/context.h"

#include "core/program/text/message.h"

namespace feedscope::iso {

bool Part::lacks(MessageCode code, char letter, int g, std::uint32_t column, Translatable effect) const {
  if (words_.has(letter)) {
    return false;
  }
  report(Severity::error, code, letter, column, [&] {
    return Text{message(NC_("core", "{} without {}"), g_name(g), letter), effect};
  });
  return true;
}

}  // namespace feedscope::iso
