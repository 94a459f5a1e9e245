#include "app/command_table.h"

#include <algorithm>

#include "core/analysis/run/run.h"
#include "core/models/control_model.h"
#include "core/program/dialect.h"

namespace feedscope {
namespace {

/// Words of "{en,fr}", CLI11's description of a value; none for another description.
std::vector<std::string> words_of(const std::string& description) {
  std::vector<std::string> words;
  const std::size_t open = description.find('{');
  const std::size_t close = description.find('}', open);
  if (open == std::string::npos || close == std::string::npos) {
    return words;
  }
  for (const std::string& entry : CLI::detail::split(description.substr(open + 1, close - open - 1), ',')) {
    words.push_back(entry.substr(0, entry.find("->")));  // of a map: key->value
  }
  return words;
}

std::vector<std::string> model_ids() {
  std::vector<std::string> ids;
  for (const ControlModel* model : all_models()) {
    ids.push_back(model->info().id);
  }
  return ids;
}

std::vector<std::string> dialect_ids() {
  std::vector<std::string> ids;
  for (const DialectInfo& info : all_dialects()) {
    ids.emplace_back(info.id);
  }
  return ids;
}

/// Words that complete the ID of `feedscope machines`.
std::vector<std::string> machines_words() {
  std::vector<std::string> words = shipped_machines().ids();
  words.emplace_back("import");
  return words;
}

/// `type`: CLI11's type name, followed by a colon and the validator's description.
std::vector<std::string> choices_of(const std::string& command, const std::string& name,
                                    const std::string& type) {
  return name == "--machine"                     ? shipped_machines().ids()
         : command == "machines" && name == "ID" ? machines_words()
         : name == "--model"                     ? model_ids()
         : name == "--dialect"                   ? dialect_ids()
                                                 : words_of(type);
}

CommandRow row_of(const CLI::App& app, const std::string& name) {
  CommandRow row{.name = name, .text = app.get_description(), .footer = app.get_footer(), .options = {}};
  for (const CLI::Option* option : app.get_options()) {
    OptionRow entry;
    entry.positional = option->get_positional();
    entry.name = entry.positional ? option->get_name(true) : "--" + option->get_lnames().front();
    const std::string type = option->get_type_name();
    entry.value =
        entry.positional || option->get_items_expected_max() == 0 ? "" : type.substr(0, type.find(':'));
    entry.text = option->get_description();
    entry.choices = choices_of(name, entry.name, type);
    row.options.push_back(std::move(entry));
  }
  return row;
}

}  // namespace

bool OptionRow::takes_file() const {
  const std::string& what = positional ? name : value;
  return what.find("FILE") != std::string::npos || what.find("DIR") != std::string::npos;
}

std::vector<CommandRow> command_table(const CLI::App& app) {
  std::vector<CommandRow> rows{row_of(app, "")};
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    rows.push_back(row_of(*command, command->get_name()));
    names.push_back(command->get_name());
  }
  for (CommandRow& row : rows) {
    for (OptionRow& option : row.options) {
      if (option.name == "COMMAND") {
        option.choices = names;
      }
    }
  }
  return rows;
}

}  // namespace feedscope
