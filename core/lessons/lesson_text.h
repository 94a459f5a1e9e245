#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/lessons/lesson.h"

namespace feedscope {

/// What the {numbers} of a lesson's texts stand for, ready to be printed: "1.267 s".
using WrittenNumbers = std::map<std::string, std::string>;

/// `text` with every {name} put in; {{ is a brace. Throws InputError with the nearest valid name for one that
/// `numbers` do not hold, and for a brace that is not closed.
std::string filled(const std::string& text, const WrittenNumbers& numbers);
/// Throws as filled() for the numbers of `lesson`, measured or not.
void check_numbers(const std::string& text, const Lesson& lesson);

/// What people call the settings of a lesson. Without a function, keys and values are as in lesson files.
struct SettingWords {
  std::function<std::string(const std::string& key)> title = {};
  /// Of values that are not numbers.
  std::function<std::string(const std::string& key, const std::string& value)> value = {};
};

/// "less than that with tolerance=0.1", "about 2.01 m/min, within 1 %".
std::string expectation_text(const Claim& claim, const std::string& language = "en",
                             const SettingWords& words = {});
/// "cycle time with tolerance=0.05 against that with tolerance=0.1"; "as it stands" for no changes.
std::string quantity_text(const LessonQuantity& quantity, const std::string& language = "en",
                          const SettingWords& words = {});
/// "s"; "%" or "" for a quantity that is put against another.
std::string unit_of(const LessonQuantity& quantity);
/// A value of a quantity with its unit: "1.267 s", "12 %", "1.59".
std::string value_text(const LessonQuantity& quantity, double value, const std::string& language = "en");
/// A value of a control: "0.01", "on".
std::string written_value(const Control& control, const std::string& value,
                          const std::string& language = "en", const SettingWords& words = {});
/// "contour_tolerance_mm: 0.01, 0.05, 0.1".
std::string control_text(const Control& control, const std::string& language = "en",
                         const SettingWords& words = {});
/// "contour_tolerance_mm=0.1" as "contour_tolerance_mm: 0.1".
std::string change_text(const std::string& change, const std::string& language = "en",
                        const SettingWords& words = {});

/// Numbers that texts of a lesson state but no simulation, claim, control or source holds, each with the text
/// it stands in: those that could become wrong without anybody being told. Not looked at: whole numbers below
/// ten without unit, and what is part of a word ("840D").
std::vector<std::string> unchecked_numbers(const Lesson& lesson);

}  // namespace feedscope
