#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/commands/command.h"
#include "app/completion.h"
#include "app/exit_codes.h"
#include "app/man_page.h"
#include "app/output_file.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/handbook/handbook.h"

namespace feedscope {
namespace {

struct HelpOptions {
  std::string command;
  std::string html;
  std::string language = "en";
  std::string shell;
  std::string out = "-";
  bool man = false;
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

void write_text(const std::string& out, const std::string& text) {
  OutputFile file(out);
  file.stream() << text;
  file.commit();
}

void write_html(const HelpOptions& options) {
  const std::filesystem::path folder = options.html;
  std::error_code ignored;  // an error shows when the first file is written
  std::filesystem::create_directories(folder, ignored);
  const Handbook handbook(options.language);
  OutputFiles files;
  for (const HandbookPage& page : handbook.pages()) {
    files.add((folder / (page.name + ".html")).string()) << whole_page_html(page, options.language);
  }
  files.commit();
  fmt::print("{} pages; open {}\n", handbook.pages().size(), (folder / "index.html").string());
}

}  // namespace

Command add_help_command(CLI::App& app) {
  const auto options = std::make_shared<HelpOptions>();
  CLI::App* command =
      app.add_subcommand("help", "Show the options of a command, or write handbook, man page or completion");
  command->add_option("COMMAND", options->command, "Command to explain [all commands]");
  command->add_option("--html", options->html, "Write the handbook as HTML pages into this folder")
      ->type_name("DIR");
  command->add_option("--language", options->language, "Language of the handbook: en or fr")
      ->check(CLI::IsMember({"en", "fr"}))
      ->type_name("LANGUAGE")
      ->needs("--html");
  CLI::Option* man = command->add_flag("--man", options->man, "Write the man page");
  command->add_option("--completion", options->shell, "Write what has a shell complete commands and options")
      ->check(CLI::IsMember(completed_shells()))
      ->type_name("SHELL")
      ->excludes(man);
  command->add_option("--out", options->out, "File for --man and --completion [standard output]")
      ->type_name("FILE");
  return {command, [&app, options] {
            if (options->man) {
              write_text(options->out, man_page(command_table(app)));
            } else if (!options->shell.empty()) {
              write_text(options->out, completion(command_table(app), options->shell));
            } else if (!options->html.empty()) {
              write_html(*options);
            } else if (!options->command.empty()) {
              show_help(app, options->command);
            } else {
              // App::help() would give that of the parsed command.
              fmt::print("{}", app.get_formatter()->make_help(&app, "feedscope", CLI::AppFormatMode::Normal));
            }
            return exit_code::done;
          }};
}

}  // namespace feedscope
