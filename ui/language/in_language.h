#pragma once

#include <QString>
#include <exception>

#include "core/base/message.h"

namespace feedscope::ui {

/// A message of the core in the user's language: its pattern translated, numbers with the decimal sign of the
/// language, texts of programs and files unchanged. In English, Message::english().
QString in_language(const Message& message);

/// Message of an error in the user's language; errors of other libraries remain as they are.
QString failure_text(const std::exception& error);

}  // namespace feedscope::ui
