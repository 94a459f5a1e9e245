#include "ui/theme/cause_colours.h"

namespace feedscope::ui {

QColor colour_of_cause(CauseKind kind, ThemeKind theme) {
  const CauseInfo& info = info_of(kind);
  return QColor::fromRgb(theme == ThemeKind::dark ? info.dark : info.light);
}

}  // namespace feedscope::ui
