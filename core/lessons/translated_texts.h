#pragma once

#include <string>
#include <vector>

#include "core/lessons/lesson.h"
#include "core/machine/config_file.h"

namespace feedscope {

/// Reads texts of a lesson file in one language. The translations of a table's texts are in a table inside it
/// that is named as the language: [fr], [question.fr].
class TranslatedTexts {
 public:
  /// `lesson`, whose numbers the texts name, outlives this. A language that lessons do not have is English.
  TranslatedTexts(const Lesson& lesson, const std::string& language);

  /// `keys`, and the names of the tables with translations.
  static std::vector<std::string> with_languages(std::vector<std::string> keys);
  /// Throws InputError if a translation in `table` has another key than `keys`, or one that `table` lacks.
  static void check(const ConfigNode& table, const std::vector<std::string>& keys, const std::string& where);

  /// The text of `key` in the language, else the English one. Throws InputError with its place if the English
  /// one is missing, or one of a language names a number that the lesson does not hold.
  std::string with_numbers(const ConfigNode& table, const std::string& key, const std::string& where);
  /// The same of a text that is shown as it is.
  std::string plain(const ConfigNode& table, const std::string& key, const std::string& where);

  /// The language asked for, or English if no text is translated.
  const std::string& language() const;
  /// What language() has no text for: "'hint' of question 2".
  std::vector<std::string> untranslated() const;

 private:
  void check_numbers_of(const ConfigNode& table, const std::string& key, const std::string& where) const;

  const Lesson& lesson_;
  std::string asked_;
  bool translated_ = false;
  std::vector<std::string> missing_;
};

}  // namespace feedscope
