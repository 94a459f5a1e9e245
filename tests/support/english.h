#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"

namespace feedscope {

inline std::vector<std::string> in_english(const std::vector<Message>& messages) {
  std::vector<std::string> texts;
  for (const Message& message : messages) {
    texts.push_back(message.english());
  }
  return texts;
}

}  // namespace feedscope
