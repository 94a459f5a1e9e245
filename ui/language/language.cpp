#include "ui/language/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QPointer>
#include <QSettings>
#include <QTranslator>
#include <utility>

namespace feedscope::ui {

namespace {

const QString english = QStringLiteral("en");
const QString key = QStringLiteral("language");

/// lupdate files a text outside of its class, Class::tr("..."), under the namespace alone.
class Translator : public QTranslator {
 public:
  using QTranslator::QTranslator;

  QString translate(const char* context, const char* text, const char* note, int n) const override {
    const QString found = QTranslator::translate(context, text, note, n);
    return found.isEmpty() ? QTranslator::translate("feedscope::ui", text, note, n) : found;
  }
};

/// The installed translators; the application owns them.
QList<QPointer<QTranslator>>& installed() {
  static QList<QPointer<QTranslator>> translators;
  return translators;
}

/// The current language.
QString& spoken() {
  static QString code = english;
  return code;
}

void install(const QString& name, const QString& folder) {
  auto* translator = new Translator(QCoreApplication::instance());
  if (translator->load(name, folder)) {
    QCoreApplication::installTranslator(translator);
    installed().append(translator);
  } else {
    delete translator;
  }
}

/// Omits group separators: a comma there is a decimal sign to others.
void write_numbers_as(QLocale locale) {
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  QLocale::setDefault(locale);
}

}  // namespace

QStringList languages() {
  return {english, QStringLiteral("fr")};
}

QString chosen_language() {
  const QString desktop = QLocale::system().name().section('_', 0, 0);
  const QString chosen = QSettings().value(key, desktop).toString();
  return languages().contains(chosen) ? chosen : english;
}

void choose_language(const QString& code) {
  if (code.isEmpty()) {
    QSettings().remove(key);
  } else {
    QSettings().setValue(key, code);
  }
}

QString spoken_language() {
  return spoken();
}

bool speaks_english() {
  return spoken() == english;
}

void install_language(const QString& code) {
  spoken() = code;
  for (const QPointer<QTranslator>& translator : std::exchange(installed(), {})) {
    delete translator;  // its destructor removes it
  }
  const bool desktop = code == QLocale::system().name().section('_', 0, 0);
  write_numbers_as(desktop ? QLocale::system() : QLocale(code));
  if (code != english) {
    install(QStringLiteral("qtbase_%1").arg(code), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install(QStringLiteral("feedscope_%1").arg(code), QStringLiteral(":/translations"));
  }
}

void speak(const QString& code) {
  install_language(code);
  write_numbers_as(QLocale(code));
}

}  // namespace feedscope::ui
