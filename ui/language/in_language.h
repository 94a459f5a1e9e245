#pragma once

#include <QString>
#include <exception>

#include "core/base/message.h"

namespace feedscope::ui {

/// A message of the library in the user's language: its pattern by the translations, numbers with the decimal
/// sign of the language, texts of programs and files as they are. In English it is Message::english().
QString in_language(const Message& message);

/// What an error says, in the user's language; what a library throws stays as it is.
QString failure_text(const std::exception& error);

}  // namespace feedscope::ui
