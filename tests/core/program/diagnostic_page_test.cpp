#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "tests/support/folders.h"

namespace feedscope {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// Codes that the readers' sources name: where a severity or a fault says what it is.
std::set<std::string> codes_of_readers(const std::filesystem::path& folder) {
  const std::regex code(
      "(?:(?:report|add)\\(\\s*[a-zA-Z_>.:-]*everity[a-z:_]*,|ReadFault\\{|Severity::[a-z]+,\\s*[a-z_.]+,\\s*"
      "[a-z_.0-9]+,)"
      "\\s*\"([a-z]+(?:-[a-z]+)*)\"");
  std::set<std::string> codes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") {
      continue;
    }
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator at(text.begin(), text.end(), code), end; at != end; ++at) {
      codes.insert((*at)[1]);
    }
  }
  return codes;
}

TEST(DiagnosticPage, NamesEveryCodeThatTheReadersSay) {
  const std::filesystem::path folder = std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "core/program";
  const std::string pages = text_of(folder / "README.md") + text_of(folder / "sinumerik/README.md") +
                            text_of(folder / "heidenhain/README.md") + text_of(folder / "iso/README.md");
  const std::set<std::string> codes = codes_of_readers(folder);
  EXPECT_GT(codes.size(), 80U);
  for (const std::string& code : codes) {
    EXPECT_NE(pages.find("`" + code + "`"), std::string::npos) << code << " is on no page of core/program";
  }
}

}  // namespace
}  // namespace feedscope
