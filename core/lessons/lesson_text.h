#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/lessons/lesson.h"

namespace feedscope {

/// Values of the {numbers} in a lesson's texts, ready for printing: "1.267 s".
using WrittenNumbers = std::map<std::string, std::string>;

/// Replaces every {name} in `text`; {{ is a brace. Throws InputError with the nearest valid name for one
/// missing in `numbers`, and for an unclosed brace.
std::string filled(const std::string& text, const WrittenNumbers& numbers);
/// `text` with no-break spaces between numbers and their units, and in fractions and equations.
std::string kept_together(const std::string& text);
/// Throws as filled() does for the numbers of `lesson`, measured or not.
void check_numbers(const std::string& text, const Lesson& lesson);

/// Titles of the settings of a lesson. Without a function, keys and values are as in lesson files.
struct SettingWords {
  /// Changes of a question, which texts name as its settings instead of repeating them.
  Changes of_question = {};
  std::function<std::string(const std::string& key)> title = {};
  /// For values that are not numbers.
  std::function<std::string(const std::string& key, const std::string& value)> value = {};
};

/// Text such as "less than that with tolerance=0.1", "about 2.01 m/min, within 1 %".
std::string expectation_text(const Claim& claim, const std::string& language = "en",
                             const SettingWords& words = {});
/// Text such as "cycle time with tolerance=0.05, less that with tolerance=0.1"; "as the lesson begins"
/// without changes.
std::string quantity_text(const LessonQuantity& quantity, const std::string& language = "en",
                          const SettingWords& words = {});
/// Unit such as "s"; "%" or "" for a quantity compared with another.
std::string unit_of(const LessonQuantity& quantity);
/// Value of a quantity with its unit: "1.267 s", "12 %", "1.59".
std::string value_text(const LessonQuantity& quantity, double value, const std::string& language = "en");
/// Value of a control: "0.01", "on".
std::string written_value(const Control& control, const std::string& value,
                          const std::string& language = "en", const SettingWords& words = {});
/// Control with its values: "contour_tolerance_mm: 0.01, 0.05, 0.1".
std::string control_text(const Control& control, const std::string& language = "en",
                         const SettingWords& words = {});
/// Change as text: "contour_tolerance_mm=0.1" is "contour_tolerance_mm: 0.1".
std::string change_text(const std::string& change, const std::string& language = "en",
                        const SettingWords& words = {});

/// Numbers in the texts of a lesson that are in no simulation, claim, control or source, each with its text:
/// they could become wrong unnoticed. Ignores whole numbers below ten without unit, and parts of words
/// ("840D").
std::vector<std::string> unchecked_numbers(const Lesson& lesson);

}  // namespace feedscope
