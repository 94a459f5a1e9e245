#include "ui/scene/cause_colour.h"

#include <cstdint>

namespace feedscope::ui {
namespace {

constexpr Rgb from_hex(std::uint32_t rgb) {
  return {static_cast<double>(rgb >> 16 & 0xff) / 255, static_cast<double>(rgb >> 8 & 0xff) / 255,
          static_cast<double>(rgb & 0xff) / 255};
}

}  // namespace

Rgb cause_colour(CauseKind kind, Background background) {
  const CauseInfo& info = info_of(kind);
  return from_hex(background == Background::dark ? info.dark : info.light);
}

}  // namespace feedscope::ui
