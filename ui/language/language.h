#pragma once

#include <QString>
#include <QStringList>

namespace feedscope::ui {

/// Codes of the window's languages; the sources are in English.
QStringList languages();
/// The language chosen by the user, or else the desktop's if available, or else English.
QString chosen_language();
/// For install_language(); empty: the desktop's.
void choose_language(const QString& code);
/// Shows all texts of the application in a language, and numbers by its rules. Needs a QApplication. An
/// existing window keeps its texts: rebuild it.
void install_language(const QString& code);
/// Sets the language of pictures, regardless of the desktop's settings.
void speak(const QString& code);
/// The current language; initially English.
QString spoken_language();
/// Whether texts appear as in the sources.
bool speaks_english();

}  // namespace feedscope::ui
