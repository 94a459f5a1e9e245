#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>
#include <vector>

#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/handbook/handbook.h"

namespace feedscope {
namespace {

struct HelpOptions {
  std::string command;
  std::string html;
  std::string language = "en";
};

void show_help(CLI::App& app, const std::string& name) {
  std::vector<std::string> names;
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == name) {
      fmt::print("{}", command->help("feedscope"));
      return;
    }
    names.push_back(command->get_name());
  }
  const std::string nearest = nearest_name(name, names);
  throw InputError(fmt::format("unknown command '{}'; {}", name,
                               nearest.empty() ? fmt::format("commands: {}", fmt::join(names, ", "))
                                               : fmt::format("did you mean '{}'?", nearest)));
}

void write_html(const HelpOptions& options) {
  const Handbook handbook(options.language);
  const auto files = write_handbook(handbook, options.language, options.html);
  fmt::print("{} pages; open {}\n", files.size(), files.front().string());
}

}  // namespace

Command add_help_command(CLI::App& app) {
  const auto options = std::make_shared<HelpOptions>();
  CLI::App* command =
      app.add_subcommand("help", "Show the options of a command, or write the handbook as HTML");
  command->add_option("COMMAND", options->command, "Command to explain [all commands]");
  command->add_option("--html", options->html, "Write the handbook as HTML pages into this folder")
      ->type_name("DIR");
  command->add_option("--language", options->language, "Language of the handbook: en or fr")
      ->check(CLI::IsMember({"en", "fr"}))
      ->type_name("LANGUAGE")
      ->needs("--html");
  return {command, [&app, options] {
            if (!options->html.empty()) {
              write_html(*options);
            } else if (!options->command.empty()) {
              show_help(app, options->command);
            } else {
              // App::help() would be that of the command that is parsed.
              fmt::print("{}", app.get_formatter()->make_help(&app, "feedscope", CLI::AppFormatMode::Normal));
            }
            return exit_code::done;
          }};
}

}  // namespace feedscope
