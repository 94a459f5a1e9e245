#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/print.h"
#include "core/models/control_model.h"

namespace feedscope {
namespace {

std::string range_text(const SettingSpec& spec) {
  if (!spec.choices.empty()) {
    return fmt::format("{}", fmt::join(spec.choices, " | "));
  }
  const std::string least =
      spec.least_above_zero > 0
          ? fmt::format("0, or from {}", plain_text(spec.least_above_zero))
          : fmt::format("{} {}", spec.minimum_allowed ? "from" : "above", plain_text(spec.minimum));
  return std::isfinite(spec.maximum) ? fmt::format("{} to {}", least, plain_text(spec.maximum)) : least;
}

void list_models() {
  TextTable table;
  for (const ControlModel* model : all_models()) {
    table.add({model->info().id, model->info().title});
  }
  fmt::print("{}", table.text("ll"));
}

void print_items(const std::vector<Message>& items) {
  for (const Message& item : items) {
    fmt::print("  - {}\n", wrapped(item.english(), 4));
  }
}

Settings fallback_settings(const ControlModel& model) {
  return complete_settings(model, Machine());
}

/// Prints the guarantees with the fallbacks of all settings, then the changes by other choices.
void print_guarantees(const ControlModel& model) {
  const Settings fallbacks = fallback_settings(model);
  const std::vector<Message> usual = sentences(model.guarantees(fallbacks));
  fmt::print("\nGuarantees\n");
  print_items(usual);
  print_items(model.info().remarks);
  for (const SettingSpec& spec : settings_of(model)) {
    for (const std::string& choice : spec.choices) {
      Settings settings = fallbacks;
      settings.set(spec.key, choice);
      std::vector<Message> changed = sentences(model.guarantees(settings));
      std::erase_if(changed, [&](const Message& sentence) {
        return std::find(usual.begin(), usual.end(), sentence) != usual.end();
      });
      if (!changed.empty()) {
        fmt::print("\nWith {} = {} instead\n", spec.key, choice);
        print_items(changed);
      }
    }
  }
}

void print_settings(const ControlModel& model) {
  TextTable table;
  for (const SettingSpec& spec : settings_of(model)) {
    const std::string fallback = spec.optional          ? "-"
                                 : spec.choices.empty() ? fmt::format("{}", spec.fallback)
                                                        : spec.choices.front();
    table.add({spec.key, fallback, spec.unit, range_text(spec)});
  }
  const std::string settings = table.text("lrll");
  fmt::print("\nSettings: key, default without a value of the machine, unit, range\n{}",
             settings.empty() ? "  none\n" : settings);
  for (const SettingSpec& spec : settings_of(model)) {
    fmt::print("\n  {}: {}.\n    {}\n", spec.key, spec.title, wrapped(spec.explanation, 4));
  }
}

void show_model(const std::string& id) {
  const ControlModel& model = find_model(id);
  const ModelInfo& info = model.info();
  fmt::print("{}: {}\n", info.id, info.title);
  if (!info.reference.empty()) {
    fmt::print("{}\n", wrapped(info.reference, 0));
  }
  fmt::print("\n{}\n", wrapped(info.summary, 0));
  print_guarantees(model);
  print_settings(model);
}

}  // namespace

Command add_models_command(CLI::App& app) {
  const auto id = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("models", "List the control models, or show one with its settings");
  command->add_option("ID", *id, "Model id");
  return {command, [id] {
            if (id->empty()) {
              list_models();
            } else {
              show_model(*id);
            }
            return exit_code::done;
          }};
}

}  // namespace feedscope
