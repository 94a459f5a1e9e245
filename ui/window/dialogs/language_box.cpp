#include "ui/window/dialogs/language_box.h"

#include <QLocale>

#include "ui/language/language.h"

namespace feedscope::ui {

LanguageBox::LanguageBox(QWidget* parent) : QComboBox(parent) {
  for (const QString& code : languages()) {
    addItem(own_name_of_language(code), code);
  }
  choose(chosen_language());
}

void LanguageBox::choose(const QString& code) {
  if (const int index = findData(code); index >= 0) {
    setCurrentIndex(index);
  }
}

QString own_name_of_language(const QString& code) {
  // Without a country: "English" rather than "American English".
  const QString name = QLocale(QLocale(code).language(), QLocale::World).nativeLanguageName();
  return name.left(1).toUpper() + name.mid(1);
}

}  // namespace feedscope::ui
