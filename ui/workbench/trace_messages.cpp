#include "ui/workbench/trace_messages.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>

#include "ui/language/in_language.h"

namespace feedscope::ui {

std::vector<Diagnostic> messages_on(const Trace& trace, const TraceOnProgram& found) {
  std::vector<Diagnostic> messages = found.remarks;
  messages.insert(messages.end(), trace.notes.begin(), trace.notes.end());
  std::ranges::stable_sort(messages, std::ranges::greater(), &Diagnostic::severity);
  return messages;
}

QString without_columns_option(QString text, const QString& instead) {
  // "..., as --columns x=2:in, where ...", ": --columns linuxcnc, or ...,rate=1000", in both languages.
  static const QRegularExpression option(
      QStringLiteral(
          "(?:,? (?:as|comme)|\\s?:) --columns \\S+?(?:, (?:or|ou) \\S+)?(?=\\s?[,.:;]?(?:\\s|$))"),
      QRegularExpression::UseUnicodePropertiesOption);
  return text.replace(option, instead);
}

QString message_text(const Diagnostic& message) {
  const auto sentence = [](const Message& text) {
    QString said = without_columns_option(
        in_language(text), QCoreApplication::translate("TraceMessages", " (Trace import options)"));
    if (!said.isEmpty()) {
      said[0] = said[0].toUpper();
      said += '.';
    }
    return said;
  };
  return (sentence(message.message) + ' ' + sentence(message.hint)).trimmed();
}

}  // namespace feedscope::ui
