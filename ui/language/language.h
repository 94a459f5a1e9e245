#pragma once

#include <QString>
#include <QStringList>

namespace feedscope::ui {

/// Codes of the languages that the window speaks; English is the one it is written in.
QStringList languages();
/// The language that the user chose, or else the desktop's if the window speaks it, or else English.
QString chosen_language();
/// For install_language(); empty: as the desktop.
void choose_language(const QString& code);
/// Makes all texts of the application appear in a language, and numbers on screen by its rules. Needs a
/// QApplication. Texts of a window that exists stay: make it again.
void install_language(const QString& code);
/// The same for pictures, whatever the desktop's settings are.
void speak(const QString& code);
/// The language in force; English at first.
QString spoken_language();
/// Whether the texts are those of the sources.
bool speaks_english();

}  // namespace feedscope::ui
