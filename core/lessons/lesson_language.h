#pragma once

#include <string>
#include <vector>

namespace feedscope {

/// Codes of the languages of lessons; the first, English, is the original language of every lesson.
const std::vector<std::string>& lesson_languages();

/// Translation of a text of Feedscope around a lesson (heading, measure, limiting cause, title of a model);
/// `english` itself if there is none.
std::string lesson_word(const std::string& english, const std::string& language);

/// Converts a number with decimal point to the decimal sign of a language: "12,5".
std::string number_in(std::string number, const std::string& language);
/// Number with its unit: "1.267 s", "90°"; in French with a no-break space: "12,5 %".
std::string number_with_unit(const std::string& number, const std::string& unit, const std::string& language);
/// Inverse of number_in() for text typed by an author: "12.5"; "" for a number with the sign of another
/// language. "5.3.2" is not changed.
std::string plain_number(const std::string& typed, const std::string& language);

/// Replaces ordinary spaces by no-break spaces where a language requires them: in French before : ; ? ! % »,
/// after «, and between a number and its unit.
std::string with_no_break_spaces(const std::string& text, const std::string& language);

}  // namespace feedscope
