#include "ui/theme/fonts.h"

namespace feedscope::ui {

QFont without_ligatures(QFont font) {
  constexpr double least = 1.0 / 64;  // [px]: Qt sets no ligatures in spaced text; too small to be visible
  font.setLetterSpacing(QFont::AbsoluteSpacing, least);
  return font;
}

QFont paper_font(int pixels, bool bold) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(pixels);
  font.setBold(bold);
  font.setHintingPreference(QFont::PreferNoHinting);
  return without_ligatures(font);
}

}  // namespace feedscope::ui
