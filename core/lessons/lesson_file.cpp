#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/analysis/run/quantity.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/lessons/lesson.h"
#include "core/lessons/lesson_language.h"
#include "core/lessons/lesson_text.h"
#include "core/lessons/translated_texts.h"
#include "core/machine/config_file.h"

namespace feedscope {
namespace {

using Names = std::vector<std::string>;

const Names measure_keys{"measure", "cause", "axis", "line", "lines"};
const Names quantity_keys{"with", "against", "as"};
const Names expectations{"less_than", "more_than", "about", "between"};

Names joined(Names first, const std::vector<Names>& more) {
  for (const Names& names : more) {
    first.insert(first.end(), names.begin(), names.end());
  }
  return first;
}

/// Runs `work` for `node` and adds the node's place to an exception.
template <typename Work>
auto at(const ConfigNode& node, Work work) {
  try {
    return work();
  } catch (const InputError& error) {
    node.fail(error.message());
  }
}

const std::string& one_of(const ConfigNode& table, const std::string& key, const Names& known,
                          const std::string& where) {
  const std::string& name = table.need_text(key, where);
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    const std::string nearest = nearest_name(name, known);
    table.need(key, where)
        .fail(fmt::format("'{}' in {} is '{}'; {}", key, where, name,
                          nearest.empty() ? fmt::format("it must be one of: {}", fmt::join(known, ", "))
                                          : fmt::format("did you mean '{}'?", nearest)));
  }
  return name;
}

double finite_number(const ConfigNode& node, const std::string& name) {
  if (!node.is_number() || !std::isfinite(node.number())) {
    node.fail(fmt::format("{} must be a number", name));
  }
  return node.number();
}

std::uint32_t whole_number(const ConfigNode& node, const std::string& name, double least) {
  const double value = finite_number(node, name);
  if (value < least || value > 1e9 || value != std::floor(value)) {
    node.fail(fmt::format("{} is {}; it must be a whole number, at least {}", name, value, least));
  }
  return static_cast<std::uint32_t>(value);
}

Names texts(const ConfigNode& node, const std::string& name) {
  Names list;
  for (const ConfigNode& item : node.items()) {
    if (!item.is_text() || item.text().empty()) {
      item.fail(fmt::format("{} must hold texts in quotes", name));
    }
    list.push_back(item.text());
  }
  if (!node.is_list() || list.empty()) {
    node.fail(fmt::format("{} must be a list of texts: [\"...\", \"...\"]", name));
  }
  return list;
}

class LessonReader {
 public:
  LessonReader(const std::filesystem::path& file, const std::string& language) : texts_(lesson_, language) {
    lesson_.file = file;
    lesson_.id = file.stem().string();
  }

  Lesson read(const ConfigNode& root) {
    const std::string where = the_file;
    root.check_keys(TranslatedTexts::with_languages({"title", "learn", "minutes", "course", "replaces",
                                                     "sources", "text", "predict", "transfer", "start",
                                                     "window", "numbers", "given", "question"}),
                    where);
    TranslatedTexts::check(root, {"title", "learn", "text", "predict", "transfer"}, where);
    lesson_.title = texts_.plain(root, "title", where);
    lesson_.learn = texts_.plain(root, "learn", where);
    lesson_.minutes = whole_number(root.need("minutes", where), "'minutes' in the file", 1);
    read_course(root, where);
    lesson_.sources = texts(root.need("sources", where), "'sources' in the file");
    read_start(root.need_table("start", where));
    if (root.find("window") != nullptr) {
      read_view(root.need_table("window", where));
    }
    read_numbers(root);
    read_given(root);
    lesson_.text = texts_.with_numbers(root, "text", where);
    lesson_.predict = optional_text(root, "predict", where);
    lesson_.transfer = optional_text(root, "transfer", where);
    read_questions(root.need("question", where));
    finish_language();
    return std::move(lesson_);
  }

 private:
  void read_course(const ConfigNode& root, const std::string& where) {
    if (root.find("course") != nullptr) {
      const Names courses{"half day", "two days"};
      lesson_.half_day = one_of(root, "course", courses, where) == courses.front();
    }
    if (root.find("replaces") != nullptr) {
      lesson_.replaces = texts(root.need("replaces", where), "'replaces' in the file");
    }
  }

  std::string optional_text(const ConfigNode& table, const std::string& key, const std::string& where) {
    return table.find(key) == nullptr ? std::string() : texts_.with_numbers(table, key, where);
  }

  void read_start(const ConfigNode& table) {
    const std::string where = "[start]";
    table.check_keys({"program", "machine", "model", "load", "set"}, where);
    SetupRequest request;
    request.machine = table.need_text("machine", where);
    at(table.need("machine", where), [&] { return make_setup(request); });
    lesson_.start.push_back("machine=" + request.machine);
    if (table.find("model") != nullptr) {
      request.model = table.need_text("model", where);
      at(table.need("model", where), [&] { return make_setup(request); });
      lesson_.start.push_back("model=" + request.model);
    }
    lesson_.start.insert(lesson_.start.begin(), "program=" + table.need_text("program", where));
    check(table.need("program", where), {});
    if (const ConfigNode* settings = table.find("set")) {
      const Changes list = changes(*settings, "'set' in [start]");
      lesson_.start.insert(lesson_.start.end(), list.begin(), list.end());
    }
    if (table.find("load") != nullptr) {
      const std::string name = table.need_text("load", where);
      at(table.need("load", where),
         [&] { return lesson_.load = read_load_file(find_load_file(lesson_, name)); });
    }
  }

  /// Checks that the lesson can be set up with `changes`.
  void check(const ConfigNode& node, const Changes& changes) {
    at(node, [&] { return setups_.set_up(lesson_, changes); });
  }

  Changes changes(const ConfigNode& node, const std::string& name) {
    if (node.is_list() && node.items().empty()) {
      return {};
    }
    Changes list = texts(node, name);
    check(node, list);
    return list;
  }

  /// Writes numbers in the language of the texts, which is known once all of them are read.
  void finish_language() {
    lesson_.language = texts_.language();
    lesson_.untranslated = texts_.untranslated();
    for (auto& [name, given] : lesson_.given) {
      given.written = number_with_unit(given.written, given.unit, lesson_.language);
    }
  }

  void read_view(const ConfigNode& table) {
    const std::string where = "[window]";
    table.check_keys({"colour", "view", "chart_s", "runs"}, where);
    if (table.find("colour") != nullptr) {
      lesson_.window.colouring = one_of(table, "colour", lesson_colourings(), where);
    }
    if (table.find("view") != nullptr) {
      lesson_.window.camera = one_of(table, "view", lesson_cameras(), where);
    }
    if (const ConfigNode* range = table.find("chart_s")) {
      lesson_.window.chart_range = number_range(*range, "'chart_s' in [window]");
    }
    if (const ConfigNode* runs = table.find("runs")) {
      if (!runs->is_list()) {
        runs->fail("'runs' in [window] must be a list of lists: [[\"tolerance=0.1\"], [\"tolerance=0.01\"]]");
      }
      for (const ConfigNode& run : runs->items()) {
        lesson_.window.runs.push_back(changes(run, "a run of 'runs' in [window]"));
      }
    }
  }

  static std::pair<double, double> number_range(const ConfigNode& node, const std::string& name) {
    if (!node.is_list() || node.items().size() != 2) {
      node.fail(fmt::format("{} must be two numbers: [from, to]", name));
    }
    const double from = finite_number(node.items()[0], name);
    const double to = finite_number(node.items()[1], name);
    if (from >= to) {
      node.fail(fmt::format("{} is [{}, {}]; the first must be less than the second", name, from, to));
    }
    return {from, to};
  }

  /// Reads the keys of measure_keys in `table`.
  static Measure measure(const ConfigNode& table, const std::string& where) {
    Measure measure;
    const ConfigNode& key = table.need("measure", where);
    table.need_text("measure", where);
    measure.spec = at(key, [&] { return &find_measure(key.text()); });
    const auto unfit = [&](const ConfigNode& node, const char* name) {
      node.fail(fmt::format("'{}' in {}: the measure {} knows none", name, where, measure.spec->key));
    };
    if (const ConfigNode* axis = table.find("axis")) {
      measure.axis = one_of(table, "axis", {"X", "Y", "Z"}, where).front();
      if (!measure.spec->of_axis) {
        unfit(*axis, "axis");
      }
    }
    if (measure.spec->of_cause) {
      measure.cause = table.need_text("cause", where);
      at(table.need("cause", where), [&] { return causes_named(measure.cause); });
    } else if (const ConfigNode* cause = table.find("cause")) {
      unfit(*cause, "cause");
    }
    read_lines(table, where, measure);
    if (measure.spec->lines == LineUse::none && measure.first_line != 0) {
      unfit(table, "line");
    }
    if (measure.spec->lines == LineUse::needed && measure.first_line == 0) {
      table.fail(fmt::format("key 'line' is missing in {}: {} is a measure of lines", where, key.text()));
    }
    return measure;
  }

  static void read_lines(const ConfigNode& table, const std::string& where, Measure& measure) {
    if (const ConfigNode* line = table.find("line")) {
      measure.first_line = measure.last_line = whole_number(*line, fmt::format("'line' in {}", where), 1);
    }
    if (const ConfigNode* lines = table.find("lines")) {
      const std::string name = fmt::format("'lines' in {}", where);
      if (measure.first_line != 0) {
        lines->fail(fmt::format("'line' and 'lines' in {}: give one of them", where));
      }
      number_range(*lines, name);
      measure.first_line = whole_number(lines->items()[0], name, 1);
      measure.last_line = whole_number(lines->items()[1], name, 1);
    }
  }

  LessonQuantity quantity(const ConfigNode& table, const std::string& where) {
    LessonQuantity quantity{measure(table, where), {}, {}, Relation::ratio, 2};
    if (const ConfigNode* with = table.find("with")) {
      quantity.with = changes(*with, fmt::format("'with' in {}", where));
    }
    if (const ConfigNode* against = table.find("against")) {
      quantity.against = changes(*against, fmt::format("'against' in {}", where));
    }
    if (const ConfigNode* as = table.find("as")) {
      const Names names{"ratio", "difference", "percent more", "percent less"};
      const std::string name = one_of(table, "as", names, where);
      if (!quantity.against) {
        as->fail(fmt::format("'as' in {} says how to compare; 'against' is missing", where));
      }
      quantity.relation = static_cast<Relation>(std::find(names.begin(), names.end(), name) - names.begin());
    }
    const bool percent =
        quantity.relation == Relation::percent_more || quantity.relation == Relation::percent_less;
    if (!quantity.against || quantity.relation == Relation::difference) {
      quantity.decimals = quantity.measure.spec->decimals;
    } else if (percent) {
      quantity.decimals = 0;
    }
    return quantity;
  }

  void read_numbers(const ConfigNode& root) {
    if (root.find("numbers") == nullptr) {
      return;
    }
    const ConfigNode& table = root.need_table("numbers", the_file);
    for (const std::string& name : table.keys()) {
      const std::string where = fmt::format("'{}' in [numbers]", name);
      const ConfigNode& entry = table.need_table(name, "[numbers]");
      entry.check_keys(joined({"decimals"}, {measure_keys, quantity_keys}), where);
      LessonQuantity number = quantity(entry, where);
      if (const ConfigNode* decimals = entry.find("decimals")) {
        number.decimals = static_cast<int>(whole_number(*decimals, "'decimals' in " + where, 0));
        if (number.decimals > 6) {
          decimals->fail(fmt::format("'decimals' in {} is {}; at most 6", where, number.decimals));
        }
      }
      lesson_.numbers.emplace(name, std::move(number));
    }
  }

  void read_given(const ConfigNode& root) {
    if (root.find("given") == nullptr) {
      return;
    }
    const ConfigNode& table = root.need_table("given", the_file);
    for (const std::string& name : table.keys()) {
      const std::string where = fmt::format("'{}' in [given]", name);
      const ConfigNode& entry = table.need_table(name, "[given]");
      entry.check_keys({"value", "unit", "source"}, where);
      if (lesson_.numbers.contains(name)) {
        entry.fail(fmt::format("{} is in [numbers] too; give it another name", where));
      }
      GivenNumber given;
      given.value = finite_number(entry.need("value", where), fmt::format("'value' of {}", where));
      given.source = entry.need_text("source", where);
      given.written = fmt::format("{}", given.value);
      if (entry.find("unit") != nullptr) {
        given.unit = entry.need_text("unit", where);
      }
      lesson_.given.emplace(name, std::move(given));
    }
  }

  /// Reads a number or the name of a given one.
  double bound(const ConfigNode& node, const std::string& name) const {
    if (!node.is_text()) {
      return finite_number(node, name + " (or the name of a number in [given], or a list of changes)");
    }
    const auto found = lesson_.given.find(node.text());
    if (found == lesson_.given.end()) {
      Names known;
      for (const auto& [given, value] : lesson_.given) {
        known.push_back(given);
      }
      const std::string nearest = nearest_name(node.text(), known);
      node.fail(fmt::format("{} is '{}', which is not in [given]{}", name, node.text(),
                            nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest)));
    }
    return found->second.value;
  }

  Claim claim(const ConfigNode& table, const std::string& where) {
    if (table.kind() != ConfigNode::Kind::table) {
      table.fail(fmt::format("{} must be a table: [[question.claim]]", where));
    }
    table.check_keys(joined({"within", "within_percent"}, {measure_keys, quantity_keys, expectations}),
                     where);
    Claim claim;
    claim.quantity = quantity(table, where);
    claim.place = table.place();
    const ConfigNode* node = nullptr;
    for (std::size_t i = 0; i < expectations.size(); ++i) {
      if (const ConfigNode* expectation = table.find(expectations[i])) {
        if (node != nullptr) {
          expectation->fail(fmt::format("{} has two of: {}", where, fmt::join(expectations, ", ")));
        }
        node = expectation;
        claim.kind = static_cast<Claim::Kind>(i);
      }
    }
    if (node == nullptr) {
      table.fail(
          fmt::format("{} claims nothing: one of {} is missing", where, fmt::join(expectations, ", ")));
    }
    const std::string name =
        fmt::format("'{}' in {}", expectations[static_cast<std::size_t>(claim.kind)], where);
    if (claim.kind == Claim::Kind::between) {
      const auto range = number_range(*node, name);
      claim.bound = range.first;
      claim.upper = range.second;
    } else if (node->is_list()) {
      claim.bound = changes(*node, name);
    } else {
      claim.bound = bound(*node, name);
    }
    read_within(table, where, claim);
    return claim;
  }

  static void read_within(const ConfigNode& table, const std::string& where, Claim& claim) {
    const ConfigNode* within = table.find("within");
    const ConfigNode* percent = table.find("within_percent");
    if (claim.kind != Claim::Kind::about) {
      if (within != nullptr || percent != nullptr) {
        (within != nullptr ? within : percent)->fail(fmt::format("'within' in {} belongs to 'about'", where));
      }
      return;
    }
    if ((within == nullptr) == (percent == nullptr)) {
      table.fail(fmt::format("'about' in {} needs one of within (in its unit) and within_percent", where));
    }
    const ConfigNode& node = within != nullptr ? *within : *percent;
    claim.within = finite_number(node, fmt::format("'within' in {}", where));
    claim.within_percent = within == nullptr;
    if (claim.within < 0) {
      node.fail(fmt::format("'within' in {} is {}; it must be at least 0", where, claim.within));
    }
  }

  Control control(const ConfigNode& table, const Changes& with, const std::string& where) {
    table.check_keys({"key", "values", "range"}, where);
    Control control;
    control.key = table.need_text("key", where);
    const ConfigNode* values = table.find("values");
    const ConfigNode* range = table.find("range");
    if ((values == nullptr) == (range == nullptr)) {
      table.fail(fmt::format("{} needs one of values = [...] and range = [from, to]", where));
    }
    control.range = range != nullptr;
    const ConfigNode& list = control.range ? *range : *values;
    const std::string name = fmt::format("'{}' in {}", control.range ? "range" : "values", where);
    if (control.range) {
      number_range(list, name);
    } else if (!list.is_list() || list.items().empty()) {
      list.fail(fmt::format("{} must be a list: [0.01, 0.05]", name));
    }
    for (const ConfigNode& item : list.items()) {
      if (!item.is_text()) {
        finite_number(item, name);
      }
      control.values.push_back(item.is_text() ? item.text() : fmt::format("{}", item.number()));
      Changes moved = with;
      moved.push_back(fmt::format("{}={}", control.key, control.values.back()));
      check(item, moved);
    }
    return control;
  }

  void read_questions(const ConfigNode& list) {
    if (!list.is_list() || list.items().empty()) {
      list.fail("'question' in the file must be tables, each under [[question]]");
    }
    for (const ConfigNode& table : list.items()) {
      const std::string where = fmt::format("question {}", lesson_.questions.size() + 1);
      if (table.kind() != ConfigNode::Kind::table) {
        table.fail("'question' in the file must be tables, each under [[question]]");
      }
      table.check_keys(
          TranslatedTexts::with_languages({"text", "with", "control", "watch", "hint", "answer", "claim"}),
          where);
      TranslatedTexts::check(table, {"text", "hint", "answer"}, where);
      Question question;
      question.text = texts_.with_numbers(table, "text", where);
      if (const ConfigNode* with = table.find("with")) {
        question.with = changes(*with, fmt::format("'with' of {}", where));
      }
      question.control =
          control(table.need_table("control", where), question.with, fmt::format("'control' of {}", where));
      question.watch = watch(table, where);
      question.hint = optional_text(table, "hint", where);
      question.answer = texts_.with_numbers(table, "answer", where);
      const ConfigNode& claims = table.need("claim", where);
      if (!claims.is_list() || claims.items().empty()) {
        claims.fail(fmt::format("'claim' of {} must be tables, each under [[question.claim]]", where));
      }
      for (const ConfigNode& one : claims.items()) {
        question.claims.push_back(
            claim(one, fmt::format("claim {} of {}", question.claims.size() + 1, where)));
      }
      lesson_.questions.push_back(std::move(question));
    }
  }

  static Measure watch(const ConfigNode& table, const std::string& where) {
    const std::string name = fmt::format("'watch' of {}", where);
    const ConfigNode& node = table.need_table("watch", where);
    node.check_keys(measure_keys, name);
    return measure(node, name);
  }

  Lesson lesson_;
  LessonSetups setups_;
  TranslatedTexts texts_;
};

}  // namespace

const std::vector<std::string>& lesson_colourings() {
  static const Names names = [] {
    Names keys;
    for (const QuantityInfo& quantity : all_quantities()) {
      if (quantity.colours) {
        keys.emplace_back(quantity.key);
      }
    }
    keys.insert(keys.end(), {"contour_error", "cause", "run"});
    return keys;
  }();
  return names;
}

const std::vector<std::string>& lesson_cameras() {
  static const Names names{"iso", "top", "front", "right", "bottom", "back", "left"};
  return names;
}

Lesson read_lesson(const std::filesystem::path& file, const std::string& language) {
  return LessonReader(file, language).read(read_config_file(file, NC_("core", "lesson")));
}

Lesson parse_lesson(const std::string& text, const std::filesystem::path& file, const std::string& language) {
  return LessonReader(file, language).read(parse_config(text, file.string()));
}

}  // namespace feedscope
