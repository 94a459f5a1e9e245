#include "ui/window/dialogs/picture_wish.h"

#include "ui/units/unit_system.h"

namespace feedscope::ui {

bool PictureWish::on_paper() const {
  const QString first = size.trimmed().left(1);
  return !first.isEmpty() && !first.front().isDigit();
}

QStringList picture_arguments(const PictureWish& wish, const QString& session) {
  QStringList arguments{session};
  const auto add = [&](const char* name, const QString& value) {
    if (!value.isEmpty()) {
      arguments.append(QStringLiteral("--%1=%2").arg(QLatin1String(name), value));
    }
  };
  add("view", wish.view);
  add("format", wish.format);
  add("size", wish.size.trimmed());
  add("dpi", wish.has_dpi() ? QString::number(wish.dpi) : QString());
  add("scale", QString::number(wish.scale));
  add("theme", wish.theme);
  add("language", wish.language);
  add("display-units", unit_system() == UnitSystem::inch ? QStringLiteral("inch") : QString());
  if (wish.transparent && wish.view != QStringLiteral("window")) {
    arguments.append(QStringLiteral("--transparent"));
  }
  return arguments;
}

PictureWish for_preview(PictureWish wish, int dpi) {
  wish.format = QStringLiteral("png");
  wish.dpi = dpi;
  return wish;
}

}  // namespace feedscope::ui
