#include "app/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/stop_signals.h"
#include "app/watch.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/base/progress.h"
#ifdef FEEDSCOPE_WITH_UI
#include "ui/language/language.h"
#endif

namespace feedscope {
namespace {

constexpr const char* out_of_memory = "feedscope: out of memory; the program is too large for this machine\n";

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return names;
}

std::string unknown(std::string_view what, const std::string& word, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(word, known);
  return fmt::format("unknown {} '{}'; {}", what, word,
                     nearest.empty() ? fmt::format("known: {}", fmt::join(known, ", "))
                                     : fmt::format("did you mean '{}'?", nearest));
}

/// The FILE given without a command, "" if none.
std::string lone_file(const CLI::App& app) {
  const CLI::Option* file = app.get_option_no_throw("FILE");
  return file == nullptr || file->count() == 0 ? "" : file->results().front();
}

/// Whether a word neither is a file nor looks like one: a misspelt command.
bool is_no_file(const std::string& word) {
  return !word.empty() && word.find_first_of("./\\") == std::string::npos && !std::filesystem::exists(word);
}

/// Message for an option without its value, with the value that is missing; "" for another error.
std::string option_without_value(const CLI::App& command, const CLI::ParseError& error) {
  const std::string what = error.what();
  const CLI::Option* option = command.get_option_no_throw(what.substr(0, what.find(':')));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr || option == nullptr) {
    return "";
  }
  return fmt::format("{0} has no value; write {0} {1}", option->get_name(), option->get_type_name());
}

/// Hint how to give several values to the option before `word`, if that was intended; otherwise "".
std::string repeat_hint(const CLI::App& command, std::span<char* const> words, const std::string& word) {
  const auto place = std::find(words.begin(), words.end(), word);
  const auto before = std::find_if(std::make_reverse_iterator(place), words.rend(), [](const char* given) {
    return std::string_view(given).starts_with("--");
  });
  const CLI::Option* option = before == words.rend() ? nullptr : command.get_option_no_throw(*before);
  if (option == nullptr || option->get_items_expected_max() <= 1) {
    return "";
  }
  return fmt::format("; repeat an option to give it several values: {0} {1} {0} {2}", *before, *before.base(),
                     word);
}

std::string explain(const CLI::App& app, std::span<char* const> words, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const std::vector<std::string> extra = app.remaining(true);
  const auto option =
      std::find_if(extra.begin(), extra.end(), [](const std::string& word) { return word.starts_with("-"); });
  if (option != extra.end()) {
    return unknown("option", option->substr(0, option->find('=')),
                   option_names(chosen.empty() ? app : *chosen.front()));
  }
  if (chosen.empty()) {
    const std::string file = lone_file(app);
    if (is_no_file(file)) {
      return unknown("command", file, command_names(app));
    }
    if (!file.empty() && !extra.empty()) {
      return fmt::format("unexpected argument '{}'", extra.front());
    }
    if (!extra.empty()) {
      return unknown("command", extra.front(), command_names(app));
    }
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
      return fmt::format("no command given; commands: {}", fmt::join(command_names(app), ", "));
    }
  }
  const std::string lacking = option_without_value(chosen.empty() ? app : *chosen.front(), error);
  return !lacking.empty() ? lacking
         : extra.empty()  ? error.what()
                          : fmt::format("unexpected argument '{}'{}", extra.front(),
                                        repeat_hint(*chosen.front(), words, extra.front()));
}

/// Refuses options given as '': ignoring them would hide a mistake.
void refuse_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string> values =
        option->count() > 0 ? option->results() : std::vector<std::string>();
    const bool may_be_empty = option->get_items_expected_min() == 0;
    if (!may_be_empty && std::ranges::find(values, "") != values.end()) {
      throw InputError(fmt::format("{} is empty; give a value or omit it", option->get_name()));
    }
  }
}

/// Refuses options of the window before a command, where they would have no effect.
void refuse_options_before_command(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() > 0 && !app.get_subcommands().empty()) {
      throw InputError(fmt::format("{0} before '{1}' is an option of the window; write feedscope {1} ... {0}",
                                   option->get_name(), app.get_subcommands().front()->get_name()));
    }
  }
}

int report_wrong_use(const CLI::App& app, std::span<char* const> words, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const std::string command = chosen.empty() ? "" : " " + chosen.front()->get_name();
  fmt::print(stderr, "feedscope: {}\nsee: feedscope{} --help\n", explain(app, words, error), command);
  return exit_code::wrong_use;
}

int report(const std::string& message, int code) {
  fmt::print(stderr, "feedscope: {}\n", message);
  return code;
}

/// Reports an exception that no input should cause.
int report_mistake(const std::exception& error) {
  return report(
      fmt::format(
          "internal error: {}; this is a bug in Feedscope, please report it with the command and its files",
          error.what()),
      exit_code::failed);
}

int run_checked(std::span<char*> arguments) {
  CLI::App app(
      "Shows what a CNC control really does with an NC program, and why it is slow where it is slow.");
  app.name("feedscope");
  app.set_version_flag("--version", "feedscope " FEEDSCOPE_VERSION);
  std::vector<Command> commands{
      add_simulate_command(app), add_explain_command(app),  add_compare_command(app),
      add_check_command(app),    add_circular_command(app), add_machines_command(app),
      add_models_command(app),   add_lessons_command(app),  add_trace_command(app),
      add_identify_command(app), add_help_command(app),     add_render_command(app),
      add_report_command(app)};
#ifdef FEEDSCOPE_WITH_UI
  commands.push_back(add_window_command(app));
  app.require_subcommand(0, 1);
#else
  app.require_subcommand(1);
#endif
  try {
    app.parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? app.exit(error) : report_wrong_use(app, arguments, error);
  }
  if (app.get_subcommands().empty() && is_no_file(lone_file(app))) {
    throw InputError(unknown("command", lone_file(app), command_names(app)));
  }
  refuse_options_before_command(app);
  refuse_empty_values(app);
  for (const CLI::App* command : app.get_subcommands()) {
    refuse_empty_values(*command);
  }
  const auto chosen = std::find_if(commands.begin(), commands.end(),
                                   [](const Command& command) { return command.options->parsed(); });
  return chosen->run();
}

int report_unwritten_text(const std::string& reason) {
  return report(fmt::format("cannot write '-': {}", reason), exit_code::wrong_use);
}

/// Flushes standard output. Returns `code`, or the code of an unwritable file if not everything was written:
/// printing may fail only at the end.
int flushed(int code) {
  errno = 0;
  std::cout.flush();
  const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
  return written ? code
                 : report_unwritten_text(errno != 0 ? std::generic_category().message(errno)
                                                    : "not everything could be written");
}

int run_reported(std::span<char*> arguments) {
  try {
    return run_checked(arguments);
  } catch (const InputError& error) {
    return report(error.what(), exit_code::wrong_use);
  } catch (const Cancelled&) {
    return report(Watch::cancelled_message, exit_code::stopped_by(Watch::stopped_by()));
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "{}", out_of_memory);
    return exit_code::failed;
  } catch (const std::filesystem::filesystem_error& error) {
    return report(fmt::format("'{}': {}", error.path1().string(), error.code().message()),
                  exit_code::wrong_use);
  } catch (const std::system_error& error) {
    return std::ferror(stdout) != 0 ? report_unwritten_text(error.code().message()) : report_mistake(error);
  } catch (const std::exception& error) {
    return report_mistake(error);
  }
}

}  // namespace

int run_command_line(std::span<char*> arguments) {
  report_file_limits();
  report_memory_limits(out_of_memory);
#ifdef FEEDSCOPE_WITH_UI
  ui::speak(ui::languages().front());  // by default from the desktop; window and --language choose theirs
#endif
  const int code = run_reported(arguments);
  return code == exit_code::done || code == exit_code::program_errors ? flushed(code) : code;
}

}  // namespace feedscope
