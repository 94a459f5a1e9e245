#include "core/lessons/lesson_language.h"

#include <algorithm>
#include <map>
#include <regex>

#include "core/base/data_folder.h"
#include "core/machine/config_file.h"

namespace feedscope {
namespace {

constexpr const char* french = "fr";
constexpr const char* no_break_space = "\u00a0";

/// Texts of a language by their English, from resources/lessons/words.
std::map<std::string, std::string> read_words(const std::string& language) {
  const auto file = data_folder() / "resources/lessons/words" / (language + ".toml");
  const ConfigNode root = read_config_file(file, NC_("core", "lesson"));
  std::map<std::string, std::string> words;
  for (const std::string& english : root.keys()) {
    words.emplace(english, root.need_text(english, the_file));
  }
  return words;
}

}  // namespace

const std::vector<std::string>& lesson_languages() {
  static const std::vector<std::string> codes{"en", french};
  return codes;
}

std::string lesson_word(const std::string& english, const std::string& language) {
  if (language != french) {
    return english;
  }
  static const std::map<std::string, std::string> words = read_words(french);
  const auto found = words.find(english);
  return found == words.end() ? english : found->second;
}

std::string number_in(std::string number, const std::string& language) {
  if (language == french) {
    std::ranges::replace(number, '.', ',');
  }
  return number;
}

std::string number_with_unit(const std::string& number, const std::string& unit,
                             const std::string& language) {
  if (unit.empty() || unit == "°") {
    return number_in(number, language) + unit;
  }
  return number_in(number, language) + (language == french ? no_break_space : " ") + unit;
}

std::string plain_number(const std::string& typed, const std::string& language) {
  if (language != french) {
    return typed;
  }
  if (const auto points = std::ranges::count(typed, '.'); points > 0) {
    return points > 1 ? typed : "";  // several points: the number of a section
  }
  std::string plain = typed;
  std::ranges::replace(plain, ',', '.');
  return plain;
}

std::string with_no_break_spaces(const std::string& text, const std::string& language) {
  if (language != french) {
    return text;
  }
  static const std::regex before_mark(R"(([^ \n]) (?=[:;?!%]|»))");
  static const std::regex after_quote("« ");
  static const std::regex before_unit(R"((\d) (?=m/|(?:mm|µm|ms|min|s)(?!\w)))");
  std::string result = std::regex_replace(text, before_mark, std::string("$1") + no_break_space);
  result = std::regex_replace(result, after_quote, std::string("«") + no_break_space);
  return std::regex_replace(result, before_unit, std::string("$1") + no_break_space);
}

}  // namespace feedscope
