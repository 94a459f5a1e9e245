#include "app/trace_columns_option.h"

#include <filesystem>

#include "core/machine/file_text.h"

namespace feedscope {

void add_columns_option(CLI::App& command, std::string& columns) {
  std::string presets;
  for (const TracePreset& preset : trace_presets()) {
    presets += (presets.empty() ? "" : ", ") + std::string(preset.name);
  }
  command
      .add_option(
          "--columns", columns,
          "What the columns of a table are, such as time=1:ms,x=2:mm,y=3:-mm,z=4:mm:-12.5,line=5 (column by "
          "number or name, unit, minus for a mirrored axis, what is added to a position; also feed, number, "
          "rate, separator, decimal, skip); a preset (" +
              presets +
              "), also with more of these, as linuxcnc,rate=500; or a file that holds such a line [found "
              "from the table]")
      ->type_name("SPEC|PRESET|FILE");
}

TraceColumns asked_columns(const std::string& columns) {
  if (columns.empty()) {
    return {};
  }
  std::error_code ignored;
  if (columns.find('=') != std::string::npos || !std::filesystem::is_regular_file(columns, ignored)) {
    return parse_trace_columns(columns);
  }
  std::string text = file_text(columns, NC_("core", "column specification"), 1);
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return parse_trace_columns(text);
}

}  // namespace feedscope
