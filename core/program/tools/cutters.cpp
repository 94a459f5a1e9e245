#include "core/program/tools/cutters.h"

#include "core/base/error.h"
#include "core/program/tools/tool_table.h"

namespace feedscope {

std::string_view to_string(CutterSource source) {
  switch (source) {
    case CutterSource::asked:
      return "asked for";
    case CutterSource::program:
      return "program";
    case CutterSource::table:
      return "tool table";
    default:
      return "not known";
  }
}

Cutters::Cutters(const ReadOptions& options, SubprogramFiles& files)
    : asked_(options.radii), wear_only_(options.wear_only), unit_(options.table_unit), files_(files) {
  if (!options.tool_table.empty()) {
    const SourceText text = SourceText::from_file(options.tool_table);
    table_ = read_tool_table(text, unit_);
    table_name_ = text.name();
    has_table_ = true;
  }
}

Cutters::Found Cutters::find(std::string_view tool, std::optional<double> programmed) {
  if (const std::optional<double> radius = asked_.find(tool)) {
    return {CutterSource::asked, *radius};
  }
  if (wear_only_) {
    return {CutterSource::asked, 0};
  }
  if (programmed) {
    return {CutterSource::program, *programmed};
  }
  if (!has_table_) {
    has_table_ = true;
    read_table_beside();
  }
  if (const std::optional<double> radius = table_.find(tool)) {
    return {CutterSource::table, *radius};
  }
  return {};
}

void Cutters::read_table_beside() {
  const std::shared_ptr<const SourceText> text = files_.find(tool_table_names());
  if (text == nullptr) {
    return;
  }
  try {
    table_ = read_tool_table(*text, unit_);
    table_name_ = text->name();
  } catch (const InputError& error) {
    table_fault_ = error.message();
  }
}

}  // namespace feedscope
