#include "app/trace_files.h"

#include <fmt/format.h>

#include "app/option_text.h"
#include "app/print.h"
#include "app/trace_columns_option.h"
#include "core/analysis/agreement/servo_period.h"
#include "core/base/error.h"
#include "core/trace/read_trace.h"
#include "ui/shared/paths.h"
#include "ui/workbench/trace_messages.h"

namespace feedscope {

namespace {

std::shared_ptr<const ui::ShownTrace> beside_run(const ui::ReportInput& input,
                                                 const std::filesystem::path& file, TraceColumns columns,
                                                 Watch& watch) {
  columns.machine_period = servo_period_of(input.run().shown->run.setup);
  const auto trace = std::make_shared<const Trace>(read_trace(file, columns, watch.stage("reading a trace")));
  auto shown = ui::lay_beside(trace, input.run().shown, watch.stage("comparing with it"));
  print_diagnostics(ui::messages_on(*trace, shown->found), file.string());
  return shown;
}

}  // namespace

void add_trace_files(CLI::App& command, TraceFiles& options) {
  command
      .add_option("--trace", options.files,
                  "What a control recorded of the program, beside the run; repeat for more")
      ->type_name("FILE")
      ->allow_extra_args(false);
  add_columns_option(command, options.columns);
}

std::string command_text(const TraceFiles& options) {
  std::string text;
  for (const std::string& file : options.files) {
    text += " --trace " + in_quotes(file);
  }
  return text + (options.columns.empty() ? "" : " --columns " + in_quotes(options.columns));
}

void add_traces(ui::ReportInput& input, const TraceFiles& options, Watch& watch) {
  if (!options.columns.empty() && options.files.empty()) {
    throw InputError("--columns says how --trace is read; give --trace FILE too");
  }
  const TraceColumns columns = asked_columns(options.columns);
  for (const std::string& file : options.files) {
    try {
      input.traces.push_back({beside_run(input, file, columns, watch),
                              ui::to_qstring(std::filesystem::path(file).filename()),
                              ui::trace_colour(input.traces.size())});
    } catch (const InputError& error) {
      throw InputError(fmt::format("trace '{}': {}", file, error.what()));
    }
  }
}

void add_traces(ui::ReportInput& input, const std::vector<ui::TraceItem>& traces, Watch& watch) {
  for (const ui::TraceItem& item : traces) {
    if (!item.visible) {
      continue;
    }
    try {
      const TraceColumns columns = item.columns.empty() ? TraceColumns() : parse_trace_columns(item.columns);
      input.traces.push_back({beside_run(input, item.file, columns, watch), item.name, item.colour});
    } catch (const InputError& error) {
      fmt::print(stderr, "feedscope: note: trace '{}' of the session is omitted: {}\n",
                 item.name.toStdString(), error.what());
    }
  }
}

}  // namespace feedscope
