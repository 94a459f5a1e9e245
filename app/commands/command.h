#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace feedscope {

/// A command of the command line: its options and its action after parsing.
struct Command {
  CLI::App* options = nullptr;
  std::function<int()> run;  ///< returns the exit code; throws InputError and Cancelled
};

Command add_simulate_command(CLI::App& app);
Command add_explain_command(CLI::App& app);
Command add_compare_command(CLI::App& app);
Command add_check_command(CLI::App& app);
Command add_circular_command(CLI::App& app);
Command add_render_command(CLI::App& app);  ///< refuses in a build without pictures, as the next one
Command add_report_command(CLI::App& app);
Command add_window_command(CLI::App& app);  ///< the program without a command; not without pictures
Command add_machines_command(CLI::App& app);
Command add_models_command(CLI::App& app);
Command add_help_command(CLI::App& app);
Command add_lessons_command(CLI::App& app);
Command add_trace_command(CLI::App& app);
Command add_identify_command(CLI::App& app);

}  // namespace feedscope
