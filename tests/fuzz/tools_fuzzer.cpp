// Any bytes as a tool table: every tool has a name and a radius.
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/program/tools/tool_table.h"
#include "tests/fuzz/must.h"

using namespace feedscope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const double unit : std::array{1.0, 25.4}) {
    CutterRadii radii;
    try {
      radii = read_tool_table(SourceText("fuzz.t", std::string(data, data + size)), unit);
    } catch (const InputError&) {
      continue;
    }
    for (const auto& [tool, radius] : radii.all()) {
      fuzz::must(!tool.empty() && tool.front() != ',', "a tool without a name");
      fuzz::must(std::isfinite(radius) && radius >= 0, "radius of " + tool);
      fuzz::must(radii.find(tool) == radius, "tool " + tool + " is not found");
    }
  }
  return 0;
}
