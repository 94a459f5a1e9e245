#include "app/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

#include "core/base/error.h"

namespace feedscope {
namespace {

std::vector<std::string> names_of(const std::vector<CommandRow>& commands) {
  std::vector<std::string> names;
  for (const CommandRow& command : commands) {
    if (!command.name.empty()) {
      names.push_back(command.name);
    }
  }
  return names;
}

std::vector<std::string> options_of(const CommandRow& command) {
  std::vector<std::string> names;
  for (const OptionRow& option : command.options) {
    if (!option.positional) {
      names.push_back(option.name);
    }
  }
  return names;
}

std::vector<std::string> choices_of_positional(const CommandRow& command) {
  const auto row = std::ranges::find_if(command.options, &OptionRow::positional);
  return row == command.options.end() ? std::vector<std::string>() : row->choices;
}

// bash
// ----------------------------------------------------------------------------------------------------------

/// The bash reply for one value: files, words or nothing.
std::string bash_reply(const OptionRow& option) {
  const std::string files = option.takes_file() ? " -f" : "";
  if (option.choices.empty() && files.empty()) {
    return "COMPREPLY=()";
  }
  const std::string words =
      option.choices.empty() ? "" : fmt::format(" -W '{}'", fmt::join(option.choices, " "));
  return fmt::format("COMPREPLY=($(compgen{}{} -- \"$word\"))", files, words);
}

std::string bash(const std::vector<CommandRow>& commands) {
  const std::vector<std::string> names = names_of(commands);
  std::string text = fmt::format(
      "# Completion of feedscope for bash, written by: feedscope help --completion bash\n"
      "_feedscope() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command= i\n"
      "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
      "    case ${{COMP_WORDS[i]}} in\n"
      "    {}) command=${{COMP_WORDS[i]}}; break ;;\n"
      "    esac\n"
      "  done\n"
      "  case $command:$before in\n",
      fmt::join(names, " | "));
  for (const CommandRow& command : commands) {
    for (const OptionRow& option : command.options) {
      if (!option.positional && !option.value.empty()) {
        text += fmt::format("  {}:{}) {}; return ;;\n", command.name, option.name, bash_reply(option));
      }
    }
  }
  text += "  esac\n  case $command:$word in\n";
  for (const CommandRow& command : commands) {
    text += fmt::format("  {}:-*) COMPREPLY=($(compgen -W '{}' -- \"$word\")) ;;\n", command.name,
                        fmt::join(options_of(command), " "));
    std::vector<std::string> words = choices_of_positional(command);
    if (command.name.empty()) {
      words = names;
    }
    text += fmt::format("  {}:*) COMPREPLY=($(compgen -f -W '{}' -- \"$word\")) ;;\n", command.name,
                        fmt::join(words, " "));
  }
  return text + "  esac\n}\ncomplete -o filenames -F _feedscope feedscope\n";
}

// zsh
// -----------------------------------------------------------------------------------------------------------

/// Escapes `text` for a single-quoted specification of _arguments.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
    } else if (c == '[' || c == ']' || c == ':' || c == '\\') {
      out += std::string("\\") + c;
    } else {
      out += c;
    }
  }
  return out;
}

bool is_word_or_file(const OptionRow& option) {
  return option.takes_file() && !option.choices.empty();
}

/// Name of the zsh function that completes such a value.
std::string zsh_function(const OptionRow& option) {
  std::string name = "_feedscope_";
  for (const char c : option.name) {
    if (c != '-') {
      name += c;
    }
  }
  return name;
}

/// The zsh functions of all values that are a word or a file.
std::string zsh_functions(const std::vector<CommandRow>& commands) {
  std::map<std::string, std::string> functions;
  for (const CommandRow& command : commands) {
    for (const OptionRow& option : command.options) {
      if (is_word_or_file(option)) {
        functions[zsh_function(option)] =
            fmt::format("{}() {{\n  _alternative 'words:word:({})' 'files:file:_files'\n}}\n",
                        zsh_function(option), fmt::join(option.choices, " "));
      }
    }
  }
  std::string text;
  for (const auto& [name, definition] : functions) {
    text += definition;
  }
  return text;
}

/// The zsh action that completes a value: words, files, both or nothing.
std::string zsh_action(const OptionRow& option) {
  if (is_word_or_file(option)) {
    return zsh_function(option);
  }
  return option.takes_file()      ? "_files"
         : option.choices.empty() ? " "
                                  : fmt::format("({})", fmt::join(option.choices, " "));
}

std::string zsh_arguments(const CommandRow& command, const std::string& indent) {
  std::string text;
  const auto positionals = std::ranges::count_if(command.options, &OptionRow::positional);
  std::ptrdiff_t place = 0;
  for (const OptionRow& option : command.options) {
    if (option.positional) {
      // The last positional takes all following words.
      const std::string which = ++place < positionals ? std::to_string(place) : "*";
      text += fmt::format(" \\\n{}'{}:{}:{}'", indent, which, zsh_text(option.name), zsh_action(option));
    } else if (option.value.empty()) {
      text += fmt::format(" \\\n{}'{}[{}]'", indent, option.name, zsh_text(option.text));
    } else {
      text += fmt::format(" \\\n{}'*{}=[{}]:{}:{}'", indent, option.name, zsh_text(option.text),
                          zsh_text(option.value), zsh_action(option));
    }
  }
  return text;
}

std::string zsh(const std::vector<CommandRow>& commands) {
  std::string text =
      "#compdef feedscope\n"
      "# Completion of feedscope for zsh, written by: feedscope help --completion zsh\n" +
      zsh_functions(commands) +
      "_feedscope() {\n"
      "  local -a commands=(\n";
  for (const CommandRow& command : commands) {
    if (!command.name.empty()) {
      text += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.text));
    }
  }
  // After the command, _arguments sees the words that it would see after a program's name.
  text += fmt::format(
      "  )\n  local i command=\n  for ((i = 2; i < CURRENT; ++i)); do\n    case $words[i] in\n"
      "    {}) command=$words[i]; words=(\"${{(@)words[i,-1]}}\"); (( CURRENT -= i - 1 )); break ;;\n"
      "    esac\n  done\n",
      fmt::join(names_of(commands), "|"));
  text += "  case $command in\n";
  for (const CommandRow& command : commands) {
    if (command.name.empty()) {
      continue;
    }
    text += fmt::format("  {})\n    _arguments{}\n    ;;\n", command.name, zsh_arguments(command, "      "));
  }
  text += fmt::format("  *)\n    _describe command commands\n    _arguments{}\n    ;;\n",
                      zsh_arguments(commands.front(), "      "));
  return text + "  esac\n}\n_feedscope \"$@\"\n";
}

// fish
// ----------------------------------------------------------------------------------------------------------

std::string fish_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'' || c == '\\') {
      out += '\\';
    }
    out += c;
  }
  return out;
}

std::string fish(const std::vector<CommandRow>& commands) {
  const std::string all = fmt::format("{}", fmt::join(names_of(commands), " "));
  std::string text = "# Completion of feedscope for fish, written by: feedscope help --completion fish\n";
  for (const CommandRow& command : commands) {
    const std::string where = command.name.empty()
                                  ? fmt::format("not __fish_seen_subcommand_from {}", all)
                                  : fmt::format("__fish_seen_subcommand_from {}", command.name);
    if (!command.name.empty()) {
      text += fmt::format("complete -c feedscope -n 'not __fish_seen_subcommand_from {}' -a {} -d '{}'\n",
                          all, command.name, fish_text(command.text));
    }
    for (const OptionRow& option : command.options) {
      const std::string words =
          option.choices.empty() ? "" : fmt::format(" -a '{}'", fmt::join(option.choices, " "));
      if (option.positional) {
        if (!words.empty()) {
          text += fmt::format("complete -c feedscope -n '{}'{}\n", where, words);
        }
        continue;
      }
      const std::string value = option.value.empty()  ? ""
                                : option.takes_file() ? " -r -F" + words
                                                      : " -x" + words;
      text += fmt::format("complete -c feedscope -n '{}' -l {}{} -d '{}'\n", where, option.name.substr(2),
                          value, fish_text(option.text));
    }
  }
  return text;
}

struct Shell {
  const char* name;
  std::string (*write)(const std::vector<CommandRow>& commands);
};

constexpr std::array shells{Shell{"bash", bash}, Shell{"zsh", zsh}, Shell{"fish", fish}};

}  // namespace

std::vector<std::string> completed_shells() {
  std::vector<std::string> names;
  for (const Shell& shell : shells) {
    names.emplace_back(shell.name);
  }
  return names;
}

std::string completion(const std::vector<CommandRow>& commands, const std::string& shell) {
  for (const Shell& known : shells) {
    if (shell == known.name) {
      return known.write(commands);
    }
  }
  throw InputError(
      fmt::format("no completion for '{}'; shells: {}", shell, fmt::join(completed_shells(), ", ")));
}

}  // namespace feedscope
