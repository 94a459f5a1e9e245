#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "tests/support/folders.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;

const fs::path readers = fs::path(FEEDSCOPE_SOURCE_DIR) / "core" / "program";

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::set<std::string> all_matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), none; match != none; ++match) {
    found.insert((*match)[1].str());
  }
  return found;
}

/// The codes that stand in the sources where something is reported.
std::set<std::string> codes_in_sources() {
  const std::regex reported(
      R"re((?:\(\s*[^"(){}]*Severity::(?:info|warning|error),\s*|ReadFault\{\s*)"([a-z]+(?:-[a-z]+)*)")re");
  std::set<std::string> codes;
  for (const auto& entry : fs::recursive_directory_iterator(readers)) {
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") {
      codes.merge(all_matches(text_of(entry.path()), reported));
    }
  }
  return codes;
}

TEST(DiagnosticCodes, StandOnThePageOfTheReaders) {
  const std::set<std::string> codes = codes_in_sources();
  EXPECT_GT(codes.size(), 80U);
  EXPECT_TRUE(codes.contains("run-limit"));
  const std::set<std::string> named =
      all_matches(text_of(readers / "README.md"), std::regex("`([a-z]+(?:-[a-z]+)*)`"));
  for (const std::string& code : codes) {
    EXPECT_TRUE(named.contains(code)) << "core/program/README.md does not name " << code;
  }
}

}  // namespace
}  // namespace feedscope
