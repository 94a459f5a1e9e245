// Commands of a build without window and pictures (FEEDSCOPE_UI=OFF) that refuse to draw, in the place of
// render.cpp and report.cpp.
#include <fmt/format.h>

#include "app/commands/command.h"
#include "core/base/error.h"

namespace feedscope {
namespace {

Command add_refused_command(CLI::App& app, const char* name) {
  CLI::App* command = app.add_subcommand(name, "Not in this build of Feedscope, which draws no pictures");
  command->allow_extras();
  return {command, [name]() -> int {
            throw InputError(
                fmt::format("'{}' needs pictures, which this build of Feedscope cannot draw; 'simulate' and "
                            "'explain' write the same numbers as text and JSON",
                            name));
          }};
}

}  // namespace

Command add_render_command(CLI::App& app) {
  return add_refused_command(app, "render");
}

Command add_report_command(CLI::App& app) {
  return add_refused_command(app, "report");
}

}  // namespace feedscope
