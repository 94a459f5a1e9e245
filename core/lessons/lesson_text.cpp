#include "core/lessons/lesson_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>
#include <set>

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/base/typed_number.h"
#include "core/lessons/lesson_language.h"
#include "core/models/control_model.h"

namespace feedscope {
namespace {

std::string in_braces(const std::string& name) {
  return '{' + name + '}';
}

[[noreturn]] void fail_unknown(const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(name, known);
  throw InputError(message(
      NC_("core", "the text speaks of {}, which is in neither [numbers] nor [given]{}"), in_braces(name),
      nearest.empty() ? Message() : message(NC_("core", "; did you mean {}?"), in_braces(nearest))));
}

template <typename... Values>
std::string in_words(const char* english, const std::string& language, const Values&... values) {
  return fmt::format(fmt::runtime(lesson_word(english, language)), values...);
}

std::string title_in(const SettingWords& words, const std::string& key) {
  return words.title ? words.title(key) : key;
}

/// Changes as in lesson files, unless `words` rename settings.
std::string changes_text(const Changes& changes, const std::string& language, const SettingWords& words) {
  if (changes.empty()) {
    return lesson_word("as the lesson begins", language);
  }
  if (!words.title) {
    return in_words("with {}", language, fmt::format("{}", fmt::join(changes, ", ")));
  }
  const auto of_question = [&](const std::string& change) {
    return std::ranges::find(words.of_question, change) != words.of_question.end();
  };
  const bool shortened = !words.of_question.empty() &&
                         std::ranges::count_if(changes, of_question) == std::ssize(words.of_question);
  std::vector<std::string> texts;
  for (const std::string& change : changes) {
    if (!shortened || !of_question(change)) {
      texts.push_back(change_text(change, language, words));
    }
  }
  const std::string list = fmt::format("{}", fmt::join(texts, lesson_word("; ", language)));
  if (shortened) {
    return texts.empty() ? lesson_word("as the question begins", language)
                         : in_words("with the question's settings and {}", language, list);
  }
  return in_words("with {}", language, list);
}

/// Calls `found` for every number in `text` that is not part of a word, with the text after it.
template <typename Found>
void each_number(const std::string& text, Found found) {
  static const std::regex pattern(
      "(^|[^\\w.,{}-])(\\d+(?:[.,]\\d+)*)(?![\\w}])((?:\\s|\u00a0)?(?:%|°|m/|mm|um|µm|ms|s\\b|degr))?");
  for (auto match = std::sregex_iterator(text.begin(), text.end(), pattern); match != std::sregex_iterator();
       ++match) {
    found((*match)[2].str(), (*match)[3].matched);
  }
}

class KnownNumbers {
 public:
  void add(const std::string& text) {
    static const std::regex number(R"(\d+(?:\.\d+)*)");
    for (auto match = std::sregex_iterator(text.begin(), text.end(), number); match != std::sregex_iterator();
         ++match) {
      values_.insert(match->str());
    }
  }
  void add(const Changes& changes) {
    for (const std::string& change : changes) {
      add(change);
    }
  }
  void add(double value) { add(fmt::format("{}", value)); }
  void add(const LessonQuantity& quantity) {
    add(quantity.with);
    if (quantity.against) {
      add(*quantity.against);
    }
    add(static_cast<double>(quantity.measure.first_line));
    add(static_cast<double>(quantity.measure.last_line));
  }
  void add(const Claim& claim) {
    add(claim.quantity);
    if (const auto* changes = std::get_if<Changes>(&claim.bound)) {
      add(*changes);
    } else {
      add(std::get<double>(claim.bound));
    }
    add(claim.upper);
  }
  bool holds(const std::string& typed, const std::string& language) const {
    return values_.contains(plain_number(typed, language));
  }

 private:
  std::set<std::string> values_;
};

KnownNumbers numbers_in_data(const Lesson& lesson) {
  KnownNumbers known;
  known.add(lesson.start);
  known.add(lesson.sources);
  for (const Changes& run : lesson.window.runs) {
    known.add(run);
  }
  for (const auto& [name, quantity] : lesson.numbers) {
    known.add(quantity);
  }
  for (const auto& [name, given] : lesson.given) {
    known.add(given.written);
    known.add(given.source);
  }
  for (const Question& question : lesson.questions) {
    known.add(question.with);
    known.add(question.control.values);
    for (const Claim& claim : question.claims) {
      known.add(claim);
    }
  }
  return known;
}

}  // namespace

std::string filled(const std::string& text, const WrittenNumbers& numbers) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '{') {
      result += text[i];
      continue;
    }
    if (i + 1 < text.size() && text[i + 1] == '{') {
      result += text[i++];
      continue;
    }
    const std::size_t end = text.find('}', i);
    if (end == std::string::npos) {
      throw InputError("'{' is not closed by '}' in the text; write {{ for the brace itself");
    }
    const std::string name = text.substr(i + 1, end - i - 1);
    const auto number = numbers.find(name);
    if (number == numbers.end()) {
      std::vector<std::string> known;
      for (const auto& [key, written] : numbers) {
        known.push_back(key);
      }
      fail_unknown(name, known);
    }
    result += number->second;
    i = end;
  }
  return result;
}

std::string kept_together(const std::string& text) {
  static const std::regex before_unit(R"((\d) (?=m/|1/|(?:m|mm|µm|ms|min|s|g|N|%)(?!\w)))");
  static const std::regex fraction(" / ");
  static const std::regex before_sign(" (?==|≤|≥)");
  static const std::regex minus(" − ");
  const std::string units =
      std::regex_replace(std::regex_replace(text, before_unit, "$1\u00a0"), minus, "\u00a0−\u00a0");
  return std::regex_replace(std::regex_replace(units, fraction, "\u00a0/\u00a0"), before_sign, "\u00a0");
}

void check_numbers(const std::string& text, const Lesson& lesson) {
  WrittenNumbers names;
  for (const auto& [name, quantity] : lesson.numbers) {
    names[name];
  }
  for (const auto& [name, given] : lesson.given) {
    names[name];
  }
  filled(text, names);
}

std::string unit_of(const LessonQuantity& quantity) {
  if (!quantity.against || quantity.relation == Relation::difference) {
    return quantity.measure.spec->unit;
  }
  return quantity.relation == Relation::ratio ? "" : "%";
}

std::string value_text(const LessonQuantity& quantity, double value, const std::string& language) {
  return number_with_unit(fmt::format("{:.{}f}", value, quantity.decimals), unit_of(quantity), language);
}

std::string quantity_text(const LessonQuantity& quantity, const std::string& language,
                          const SettingWords& words) {
  const std::string text = fmt::format("{} {}", title_of(quantity.measure, language),
                                       changes_text(quantity.with, language, words));
  if (!quantity.against) {
    return text;
  }
  static const std::vector<const char*> relations{"{}, over that {}", "{}, less that {}",
                                                  "{}, in percent more than that {}",
                                                  "{}, in percent less than that {}"};
  return in_words(relations[static_cast<std::size_t>(quantity.relation)], language, text,
                  changes_text(*quantity.against, language, words));
}

std::string expectation_text(const Claim& claim, const std::string& language, const SettingWords& words) {
  const auto with_unit = [&](double value) {
    return number_with_unit(fmt::format("{}", value), unit_of(claim.quantity), language);
  };
  const auto* changes = std::get_if<Changes>(&claim.bound);
  const std::string bound = changes != nullptr
                                ? in_words("that {}", language, changes_text(*changes, language, words))
                                : with_unit(std::get<double>(claim.bound));
  switch (claim.kind) {
    case Claim::Kind::less_than:
      return in_words("less than {}", language, bound);
    case Claim::Kind::more_than:
      return in_words("more than {}", language, bound);
    case Claim::Kind::about:
      return in_words("about {}, within {}", language, bound,
                      claim.within_percent ? number_with_unit(fmt::format("{}", claim.within), "%", language)
                                           : with_unit(claim.within));
    case Claim::Kind::between:
      return in_words("between {} and {}", language, bound, with_unit(claim.upper));
  }
  return bound;
}

std::string written_value(const Control& control, const std::string& value, const std::string& language,
                          const SettingWords& words) {
  if (typed_number(value).value) {
    return number_in(value, language);
  }
  return words.value ? words.value(control.key, value) : value;
}

std::string control_text(const Control& control, const std::string& language, const SettingWords& words) {
  const std::string name = title_in(words, control.key);
  std::vector<std::string> values;
  for (const std::string& value : control.values) {
    values.push_back(written_value(control, value, language, words));
  }
  if (control.range) {
    return fmt::format(fmt::runtime(lesson_word("{}: from {} to {}", language)), name, values.front(),
                       values.back());
  }
  return fmt::format(fmt::runtime(lesson_word("{}: {}", language)), name,
                     fmt::join(values, lesson_word(", ", language)));
}

std::string change_text(const std::string& change, const std::string& language, const SettingWords& words) {
  const std::string key = assigned_key(change);
  return control_text({key, {change.substr(key.size() + 1)}, false}, language, words);
}

std::vector<std::string> unchecked_numbers(const Lesson& lesson) {
  const KnownNumbers known = numbers_in_data(lesson);
  const bool mixed = !lesson.untranslated.empty();
  std::vector<std::string> found;
  const auto look = [&](const std::string& text, const std::string& where) {
    each_number(text, [&](const std::string& number, bool with_unit) {
      const bool small = number.size() == 1 && !with_unit;
      const bool held = known.holds(number, lesson.language) || (mixed && known.holds(number, "en"));
      if (!small && !held) {
        found.push_back(fmt::format("{} in {}", number, where));
      }
    });
  };
  look(lesson.learn, "'learn'");
  look(lesson.text, "the text");
  look(lesson.predict, "'predict'");
  look(lesson.transfer, "'transfer'");
  for (std::size_t i = 0; i < lesson.questions.size(); ++i) {
    const Question& question = lesson.questions[i];
    look(question.text, fmt::format("question {}", i + 1));
    look(question.hint, fmt::format("the hint of question {}", i + 1));
    look(question.answer, fmt::format("the answer of question {}", i + 1));
  }
  return found;
}

}  // namespace feedscope
