#pragma once

#include <string>
#include <vector>

namespace feedscope {

/// Codes of the languages of lessons; the first, English, is the one that every lesson is written in.
const std::vector<std::string>& lesson_languages();

/// A text of Feedscope around a lesson (heading, measure, limiting cause, title of a model) in a language;
/// `english` itself where there is none.
std::string lesson_word(const std::string& english, const std::string& language);

/// A number, written with a decimal point, with the decimal sign of a language: "12,5".
std::string number_in(std::string number, const std::string& language);
/// With its unit: "1.267 s", "90°"; in French with a no-break space: "12,5 %".
std::string number_with_unit(const std::string& number, const std::string& unit, const std::string& language);
/// The reverse of number_in() for what an author typed: "12.5"; "" for a number with the sign of another
/// language. "5.3.2" stays as it is.
std::string plain_number(const std::string& typed, const std::string& language);

/// A text typed with ordinary spaces with no-break spaces where a language wants them: in French before
/// : ; ? ! % », after «, and between a number and its unit.
std::string with_no_break_spaces(const std::string& text, const std::string& language);

}  // namespace feedscope
