#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/watch.h"
#include "ui/report/report_input.h"

namespace feedscope {

/// Traces that a picture or report shows beside its current run, as typed.
struct TraceFiles {
  std::vector<std::string> files;
  std::string columns;  ///< of all of them; empty: found from each file
};

/// Adds --trace and --columns.
void add_trace_files(CLI::App& command, TraceFiles& options);

/// As it is typed behind a command: " --trace a.csv --columns time=1,x=2"; empty without traces.
std::string command_text(const TraceFiles& options);

/// Reads what was asked for and lays it beside the current run of `input`; what is wrong with it is told on
/// standard error. Throws InputError naming the trace that cannot be read or is nowhere on the program, and
/// Cancelled.
void add_traces(ui::ReportInput& input, const TraceFiles& options, Watch& watch);
/// The visible traces of a session; one that cannot be used is reported on standard error and omitted.
void add_traces(ui::ReportInput& input, const std::vector<ui::TraceItem>& traces, Watch& watch);

}  // namespace feedscope
