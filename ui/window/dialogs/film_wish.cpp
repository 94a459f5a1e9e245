#include "ui/window/dialogs/film_wish.h"

#include "ui/units/unit_system.h"

namespace feedscope::ui {

QStringList film_arguments(const FilmWish& wish, const QString& session) {
  QStringList arguments{session};
  const auto add = [&](const char* name, const QString& value) {
    if (!value.isEmpty()) {
      arguments.append(QStringLiteral("--%1=%2").arg(QLatin1String(name), value));
    }
  };
  const auto number = [](double value) { return QString::number(value, 'g', 12); };
  add("from", number(wish.times.from));
  add("to", number(wish.times.to));
  add("speed", number(wish.times.speed));
  add("fps", QString::number(wish.times.fps));
  add("trail", number(wish.trail));
  add("size", wish.size.trimmed());
  add("theme", wish.theme);
  add("language", wish.language);
  add("display-units", unit_system() == UnitSystem::inch ? QStringLiteral("inch") : QString());
  if (wish.charts) {
    arguments.append(QStringLiteral("--charts"));
  }
  return arguments;
}

}  // namespace feedscope::ui
