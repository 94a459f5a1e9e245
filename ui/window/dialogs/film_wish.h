#pragma once

#include <QString>
#include <QStringList>

#include "ui/film/film_times.h"

namespace feedscope::ui {

/// Options of a film; keys and sizes in the words of `feedscope render`.
struct FilmWish {
  FilmTimes times;
  double trail = 0;     ///< [s] of the run; 0: none
  bool charts = false;  ///< below the view
  QString size = QStringLiteral("1280x720");
  QString theme;     ///< light, dark; empty: the window's
  QString language;  ///< empty: English
};

/// Arguments of `feedscope render` for such a film of a session file, without --film.
QStringList film_arguments(const FilmWish& wish, const QString& session);

}  // namespace feedscope::ui
