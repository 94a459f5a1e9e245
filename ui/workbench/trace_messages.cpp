#include "ui/workbench/trace_messages.h"

#include <algorithm>

#include "ui/language/composed_text.h"

namespace feedscope::ui {

std::vector<Diagnostic> messages_on(const Trace& trace, const TraceOnProgram& found) {
  std::vector<Diagnostic> messages = found.remarks;
  messages.insert(messages.end(), trace.notes.begin(), trace.notes.end());
  std::ranges::stable_sort(messages, std::ranges::greater(), &Diagnostic::severity);
  return messages;
}

QString message_text(const Diagnostic& message) {
  const auto sentence = [](const std::string& text) {
    QString said = composed_text(text);
    if (!said.isEmpty()) {
      said[0] = said[0].toUpper();
      said += '.';
    }
    return said;
  };
  return (sentence(message.message) + ' ' + sentence(message.hint)).trimmed();
}

}  // namespace feedscope::ui
