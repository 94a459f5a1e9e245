#include "core/program/sinumerik/language/macros.h"

#include <algorithm>

#include "core/program/sinumerik/language/names.h"
#include "core/program/text/scanner.h"

namespace feedscope::sinumerik {

namespace {

std::size_t name_end(std::string_view line, std::size_t at) {
  while (at < line.size() && letters::is_name_part(line[at])) {
    ++at;
  }
  return at;
}

}  // namespace

std::uint32_t Macros::Line::written_column(std::uint32_t column) const {
  if (column == 0) {
    return 0;
  }
  std::size_t at = column - 1;
  for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
    if (at >= piece->end) {
      at = at - piece->end + piece->written_end;
      break;
    }
    if (at >= piece->begin) {
      at = piece->written_begin;
      break;
    }
  }
  return static_cast<std::uint32_t>(at) + 1;
}

void Macros::define(std::string_view name, std::string_view words) {
  words_[upper_case(name)] = words;
}

std::optional<Macros::Line> Macros::replaced(std::string_view line) const {
  Line result;
  std::size_t copied = 0;
  for (std::size_t at = 0; at < line.size() && line[at] != ';';) {
    if (line[at] == '"') {
      at = std::min(line.find('"', at + 1), line.size() - 1) + 1;
      continue;
    }
    const std::size_t end = name_end(line, at);
    if (end == at) {
      ++at;
      continue;
    }
    const std::string name = upper_case(line.substr(at, end - at));
    if (name == "DEFINE") {
      return std::nullopt;
    }
    if (const auto macro = words_.find(name); macro != words_.end()) {
      result.text += line.substr(copied, at - copied);
      const std::size_t begin = result.text.size();
      result.text += macro->second;
      result.pieces.push_back(
          {.begin = begin, .end = result.text.size(), .written_begin = at, .written_end = end});
      copied = end;
    }
    at = end;
  }
  if (result.pieces.empty()) {
    return std::nullopt;
  }
  result.text += line.substr(copied);
  return result;
}

}  // namespace feedscope::sinumerik
