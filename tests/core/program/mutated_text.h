#pragma once

#include <random>
#include <string>

namespace feedscope {

/// `text` with one to six edits: a character changed, some left out, some written twice, the end cut off.
inline std::string mutated(std::string text, std::mt19937& random) {
  for (std::size_t edits = 1 + random() % 6; edits > 0 && !text.empty(); --edits) {
    const std::size_t at = random() % text.size();
    switch (random() % 4) {
      case 0:
        text[at] = static_cast<char>(' ' + random() % 224);
        break;
      case 1:
        text.erase(at, 1 + random() % 8);
        break;
      case 2:
        text.insert(at, text.substr(random() % text.size(), 1 + random() % 12));
        break;
      default:
        text.resize(at + (text.size() - at) / 2);
        break;
    }
  }
  return text;
}

}  // namespace feedscope
