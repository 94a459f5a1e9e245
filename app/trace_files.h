#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/watch.h"
#include "ui/report/report_input.h"

namespace feedscope {

/// Traces that a picture or report compares with its current run, as typed.
struct TraceFiles {
  std::vector<std::string> files;
  std::string columns;  ///< of all traces; empty: detected for each file
};

/// Adds --trace and --columns.
void add_trace_files(CLI::App& command, TraceFiles& options);

/// The options as typed after a command: " --trace a.csv --columns time=1,x=2"; empty without traces.
std::string command_text(const TraceFiles& options);

/// Reads the traces and places them on the current run of `input`; their defects are printed to standard
/// error. Throws InputError naming a trace that is unreadable or nowhere on the program, and Cancelled.
void add_traces(ui::ReportInput& input, const TraceFiles& options, Watch& watch);
/// Adds the visible traces of a session; unusable ones are reported on standard error and omitted.
void add_traces(ui::ReportInput& input, const std::vector<ui::TraceItem>& traces, Watch& watch);

}  // namespace feedscope
