#include "core/program/sinumerik/language/subprograms.h"

#include <vector>

#include "core/program/sinumerik/language/names.h"

namespace feedscope::sinumerik {

namespace {

/// File name without folder and drive.
std::string_view file_name(std::string_view written) {
  return written.substr(written.find_last_of("/\\:") + 1);
}

}  // namespace

std::string plain_name(std::string_view written) {
  std::string name = upper_case(file_name(written));
  if (name.starts_with("_N_")) {
    name.erase(0, 3);
  }
  for (const std::string_view ending : {"_SPF", "_MPF", ".SPF", ".MPF"}) {
    if (name.ends_with(ending)) {
      name.resize(name.size() - ending.size());
    }
  }
  return name;
}

Subprogram Subprograms::find(std::string_view written) {
  const std::string name = plain_name(written);
  for (const auto& text : {lines_.text_in_force(), lines_.main_text()}) {
    const ProgramIndex& index = indexes_.of(*text);
    const ProgramIndex::Section* const section = index.section(name);
    const bool is_caller = section != nullptr && section->main && lines_.call_depth() == 0 &&
                           text == lines_.text_in_force() && section == &index.section_of(lines_.line());
    if (section != nullptr && !is_caller) {
      return {text, section->first};
    }
  }
  const std::vector<std::string> files{name + ".SPF", name + ".MPF", "_N_" + name + "_SPF",
                                       "_N_" + name + "_MPF", std::string(file_name(written))};
  return {files_.find(files), 1};
}

}  // namespace feedscope::sinumerik
