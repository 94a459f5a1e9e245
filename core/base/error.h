#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/message.h"

namespace feedscope {

/// Wrong use or unreadable input: machine file, option, call, file. The message has thing, value, place and
/// advice; the command line prints it and exits with code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(Message message)
      : std::runtime_error(message.english()), message_(std::move(message)) {}
  explicit InputError(std::string text) : InputError(Message::as_written(std::move(text))) {}

  const Message& message() const { return message_; }

 private:
  Message message_;
};

}  // namespace feedscope
