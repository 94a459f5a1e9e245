#include "app/man_page.h"

#include <fmt/format.h>

#include "app/exit_codes.h"

namespace feedscope {
namespace {

/// Escapes for roff: a backslash, a typed hyphen, and a control character at the start of a line.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) {
      out += std::string("\\&") + c;
    } else {
      out += c;
    }
  }
  return out;
}

std::string option_entry(const OptionRow& option) {
  const std::string head = option.positional ? fmt::format("\\fI{}\\fR", roff(option.name))
                           : option.value.empty()
                               ? fmt::format("\\fB{}\\fR", roff(option.name))
                               : fmt::format("\\fB{}\\fR \\fI{}\\fR", roff(option.name), roff(option.value));
  return fmt::format(".TP\n{}\n{}.\n", head, roff(option.text));
}

std::string synopsis(const CommandRow& command) {
  std::string line = fmt::format(".B feedscope {}\n", command.name);
  for (const OptionRow& option : command.options) {
    if (option.positional) {
      line += fmt::format(".RI [ {} ]\n", option.name);
    }
  }
  return line + ".RI [ option ...]\n.br\n";
}

std::string entries(const CommandRow& command) {
  std::string text;
  for (const OptionRow& option : command.options) {
    text += option_entry(option);
  }
  if (!command.footer.empty()) {
    text += fmt::format(".PP\n{}\n", roff(command.footer));
  }
  return text;
}

std::string exit_codes() {
  std::string text = ".SH EXIT STATUS\n";
  const auto add = [&text](int code, const char* meaning) {
    text += fmt::format(".TP\n.B {}\n{}\n", code, meaning);
  };
  add(exit_code::done, "Done.");
  add(exit_code::program_errors,
      "The NC program, or the configuration that is imported, has errors; results of the rest are written. "
      "Of lessons: a claim does not hold.");
  add(exit_code::wrong_use,
      "Wrong option or value; a file that cannot be read or written; a trace that does not belong to its "
      "program.");
  add(exit_code::failed, "Out of memory, or an internal error.");
  return text + ".TP\n.B 128 + n\nStopped by signal n: 130 for Ctrl\\-C. Nothing half written is left.\n";
}

}  // namespace

std::string man_page(const std::vector<CommandRow>& commands) {
  const CommandRow& window = commands.front();
  std::string page = fmt::format(
      ".TH FEEDSCOPE 1 \"\" \"feedscope {}\" \"User commands\"\n"
      ".SH NAME\nfeedscope \\- show what a CNC control does with an NC program\n.SH SYNOPSIS\n",
      FEEDSCOPE_VERSION);
  for (const CommandRow& command : commands) {
    page += synopsis(command);
  }
  page += fmt::format(
      ".SH DESCRIPTION\n{}\n.PP\nWithout a command the window opens. A session (*.feedscope) may take the "
      "place of an NC "
      "program, and \\- is standard input or output.\n{}",
      roff(window.text), entries(window));
  page += ".SH COMMANDS\n";
  for (std::size_t i = 1; i < commands.size(); ++i) {
    page +=
        fmt::format(".SS {}\n{}.\n{}", roff(commands[i].name), roff(commands[i].text), entries(commands[i]));
  }
  page += exit_codes();
  page +=
      ".SH ENVIRONMENT\n"
      ".TP\n.B FEEDSCOPE_DATA\nFolder with machines, sample programs and lessons, instead of the installed "
      "one.\n"
      ".TP\n.B FEEDSCOPE_OFFSCREEN\nosmesa or egl: what draws pictures without a display [the first that is "
      "installed].\n"
      ".SH SEE ALSO\nThe handbook: Help in the window, or\n.B feedscope help \\-\\-html\n.IR folder .\n";
  return page;
}

}  // namespace feedscope
