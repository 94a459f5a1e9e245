#include <fmt/format.h>
#include <fmt/ranges.h>

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
  const std::string least = fmt::format("{} {}", spec.minimum_allowed ? "from" : "above", spec.minimum);
  return std::isfinite(spec.maximum) ? fmt::format("{} to {}", least, spec.maximum) : least;
}

void list_models() {
  TextTable table;
  for (const ControlModel* model : all_models()) {
    table.add({model->info().id, model->info().title});
  }
  fmt::print("{}", table.text("ll"));
}

void show_model(const std::string& id) {
  const ControlModel& model = find_model(id);
  const ModelInfo& info = model.info();
  fmt::print("{}: {}\n", info.id, info.title);
  if (!info.reference.empty()) {
    fmt::print("{}\n", info.reference);
  }
  fmt::print("\n{}\n", info.summary);
  if (!info.guarantees.empty()) {
    fmt::print("\nGuarantees\n  - {}\n", fmt::join(info.guarantees, "\n  - "));
  }
  TextTable table;
  for (const SettingSpec& spec : settings_of(model)) {
    const std::string fallback =
        spec.choices.empty() ? fmt::format("{}", spec.fallback) : spec.choices.front();
    table.add({spec.key, fallback, spec.unit, range_text(spec), spec.explanation});
  }
  const std::string settings = table.text("lrlll");
  fmt::print("\nSettings: key, value where the machine gives none, unit, range\n{}",
             settings.empty() ? "  none\n" : settings);
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
