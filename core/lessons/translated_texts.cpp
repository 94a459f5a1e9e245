#include "core/lessons/translated_texts.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/lessons/lesson_language.h"
#include "core/lessons/lesson_text.h"

namespace feedscope {
namespace {

/// Every language but English.
std::vector<std::string> translations() {
  return {lesson_languages().begin() + 1, lesson_languages().end()};
}

std::string name_of(const std::string& language, const std::string& where) {
  return fmt::format("'{}' of {}", language, where);
}

}  // namespace

TranslatedTexts::TranslatedTexts(const Lesson& lesson, const std::string& language)
    : lesson_(lesson),
      asked_(std::ranges::count(lesson_languages(), language) > 0 ? language : lesson_languages().front()) {}

std::vector<std::string> TranslatedTexts::with_languages(std::vector<std::string> keys) {
  const std::vector<std::string> names = translations();
  keys.insert(keys.end(), names.begin(), names.end());
  return keys;
}

void TranslatedTexts::check(const ConfigNode& table, const std::vector<std::string>& keys,
                            const std::string& where) {
  for (const std::string& language : translations()) {
    if (table.find(language) == nullptr) {
      continue;
    }
    const std::string name = name_of(language, where);
    const ConfigNode& translation = table.need_table(language, where);
    translation.check_keys(keys, name);
    for (const std::string& key : translation.keys()) {
      translation.need_text(key, name);
      if (table.find(key) == nullptr) {
        translation.need(key, name).fail(
            fmt::format("'{}' in {}: there is no English '{}' to translate", key, name, key));
      }
    }
  }
}

std::string TranslatedTexts::plain(const ConfigNode& table, const std::string& key,
                                   const std::string& where) {
  const std::string& english = table.need_text(key, where);
  if (asked_ == lesson_languages().front()) {
    return english;
  }
  const ConfigNode* translation = table.find(asked_);
  if (translation == nullptr || translation->find(key) == nullptr) {
    missing_.push_back(fmt::format("'{}' of {}", key, where));
    return english;
  }
  translated_ = true;
  return with_no_break_spaces(translation->need_text(key, name_of(asked_, where)), asked_);
}

std::string TranslatedTexts::with_numbers(const ConfigNode& table, const std::string& key,
                                          const std::string& where) {
  check_numbers_of(table, key, where);
  for (const std::string& language : translations()) {
    const ConfigNode* translation = table.find(language);
    if (translation != nullptr && translation->find(key) != nullptr) {
      check_numbers_of(*translation, key, name_of(language, where));
    }
  }
  return plain(table, key, where);
}

void TranslatedTexts::check_numbers_of(const ConfigNode& table, const std::string& key,
                                       const std::string& where) const {
  const std::string& text = table.need_text(key, where);
  try {
    check_numbers(text, lesson_);
  } catch (const InputError& error) {
    table.need(key, where).fail(error.message());
  }
}

const std::string& TranslatedTexts::language() const {
  return translated_ ? asked_ : lesson_languages().front();
}

std::vector<std::string> TranslatedTexts::untranslated() const {
  return missing_;
}

}  // namespace feedscope
