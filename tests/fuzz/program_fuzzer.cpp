// Any bytes as an NC program: reading ends, and what comes out can be worked with.
#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/toolpath/toolpath.h"
#include "tests/fuzz/must.h"
#include "tests/support/program_checks.h"

namespace {

using namespace feedscope;

/// The first byte, where it is one of the first control characters, forces a dialect.
ReadOptions options_of(std::string& text) {
  ReadOptions options;
  options.repeat_limit = 300;
  options.call_depth = 10;
  const std::size_t first = text.empty() ? 0 : static_cast<unsigned char>(text[0]);
  if (first >= 1 && first <= all_dialects().size()) {
    options.dialect = all_dialects()[first - 1].dialect;
    text.erase(0, 1);
  }
  return options;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(data, data + size);
  const ReadOptions options = options_of(text);
  std::shared_ptr<const SourceText> source;
  try {
    source = std::make_shared<const SourceText>("fuzz.nc", std::move(text));
  } catch (const InputError&) {
    return -1;  // no text
  }
  ReadProgram program = read_program(source, nullptr, options);
  const std::string wrong = insane_part(program);
  const Toolpath toolpath = build_toolpath(program);
  fuzz::must(wrong.empty(), wrong);
  fuzz::must(std::isfinite(toolpath.length()), "path length");
  return 0;
}
