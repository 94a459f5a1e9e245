#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "ui/report/report_input.h"
#include "ui/session/session.h"

namespace feedscope {

/// English, which commands speak where nobody asks for another language.
std::string usual_language();

/// Adds --language, the language of what a command draws and writes into files. A wrong one is refused with
/// those that are there.
void add_language_option(CLI::App& command, std::string& language);

/// Makes texts and numbers of what is drawn those of a language, with the names of its runs that nobody has
/// named. Needs a QApplication. Nothing changes for usual_language().
void speak_in(const std::string& language, ui::ReportInput& input, const std::optional<ui::Session>& session);

}  // namespace feedscope
