#pragma once

#include <QString>
#include <QStringList>

#include "ui/report/film_times.h"

namespace feedscope::ui {

/// What a film is to be like; keys and sizes in the words of `feedscope render`.
struct FilmWish {
  FilmTimes times;
  double trail = 0;     ///< [s] of the run; 0: none
  bool charts = false;  ///< below the view
  QString size = QStringLiteral("1280x720");
  QString theme;     ///< light, dark; empty: as in the window
  QString language;  ///< empty: English
};

/// Arguments of `feedscope render` that film a session file so: all but --film.
QStringList film_arguments(const FilmWish& wish, const QString& session);

}  // namespace feedscope::ui
