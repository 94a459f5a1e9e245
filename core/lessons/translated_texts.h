#pragma once

#include <string>
#include <vector>

#include "core/lessons/lesson.h"
#include "core/machine/config_file.h"

namespace feedscope {

/// Reads texts of a lesson file in one language. Translations of a table's texts are in a subtable named
/// after the language: [fr], [question.fr].
class TranslatedTexts {
 public:
  /// `lesson`, whose numbers the texts refer to, outlives this. An unsupported language falls back to
  /// English.
  TranslatedTexts(const Lesson& lesson, const std::string& language);

  /// `keys`, and the names of the tables with translations.
  static std::vector<std::string> with_languages(std::vector<std::string> keys);
  /// Throws InputError if a translation in `table` has a key that is not in `keys` or not in `table`.
  static void check(const ConfigNode& table, const std::vector<std::string>& keys, const std::string& where);

  /// Text of `key` in the language, else in English. Throws InputError with its place if the English one is
  /// missing, or if a translation refers to an unknown number of the lesson.
  std::string with_numbers(const ConfigNode& table, const std::string& key, const std::string& where);
  /// Text that is shown unchanged.
  std::string plain(const ConfigNode& table, const std::string& key, const std::string& where);

  /// Requested language, or English if no text is translated.
  const std::string& language() const;
  /// Texts missing in language(): "'hint' of question 2".
  std::vector<std::string> untranslated() const;

 private:
  void check_numbers_of(const ConfigNode& table, const std::string& key, const std::string& where) const;

  const Lesson& lesson_;
  std::string asked_;
  bool translated_ = false;
  std::vector<std::string> missing_;
};

}  // namespace feedscope
