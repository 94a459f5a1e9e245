#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "ui/report/report_input.h"
#include "ui/session/session.h"

namespace feedscope {

/// English: the language of commands without --language.
std::string usual_language();

/// Adds --language, the language of pictures and written files. Refuses an unknown one with a list of those
/// available.
void add_language_option(CLI::App& command, std::string& language);

/// Switches the texts and numbers of drawings to a language, with the default names of its runs. Needs a
/// QApplication. Nothing changes for usual_language().
void speak_in(const std::string& language, ui::ReportInput& input, const std::optional<ui::Session>& session);

}  // namespace feedscope
