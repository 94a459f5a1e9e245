#include "ui/language/in_language.h"

#include <QCoreApplication>
#include <QLocale>
#include <vector>

#include "core/base/error.h"
#include "ui/language/language.h"

namespace feedscope::ui {

namespace {

QString translated(const Message& message) {
  const QString text = QString::fromStdString(message.text());
  switch (message.kind()) {
    case Message::Kind::written:
      return text;
    case Message::Kind::number:
      return QString(text).replace('.', QLocale().decimalPoint());
    case Message::Kind::pattern:
      break;
  }
  const QString pattern = QCoreApplication::translate("core", message.text().c_str());
  std::vector<std::string> parts;
  for (const Message& argument : message.arguments()) {
    parts.push_back(translated(argument).toStdString());
  }
  return QString::fromStdString(filled(pattern.toStdString(), parts));
}

}  // namespace

QString in_language(const Message& message) {
  return speaks_english() ? QString::fromStdString(message.english()) : translated(message);
}

QString failure_text(const std::exception& error) {
  const auto* const known = dynamic_cast<const InputError*>(&error);
  return known != nullptr ? in_language(known->message()) : QString::fromUtf8(error.what());
}

}  // namespace feedscope::ui
