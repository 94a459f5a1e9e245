#include "core/program/text/message_codes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "core/handbook/handbook.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

using testing::HasSubstr;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(MessageCodes, AreDifferent) {
  std::set<std::string_view> codes;
  for (const MessageCodeInfo& info : message_codes) {
    EXPECT_TRUE(codes.insert(info.code).second) << info.code;
  }
}

TEST(MessageCodes, AreReportedSomewhere) {
  const std::filesystem::path core = std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "core";
  std::string sources;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(core)) {
    if (entry.path().extension() == ".cpp" || entry.path().filename() == "path_writer.h") {
      sources += text_of(entry.path());
    }
  }
  for (const MessageCodeInfo& info : message_codes) {
    EXPECT_NE(sources.find("\"" + std::string(info.code) + "\""), std::string::npos) << info.code;
  }
}

TEST(MessageCodes, AreOnThePageOfMessagesInEveryLanguage) {
  for (const std::string language : {"en", "fr"}) {
    const Handbook handbook(language);
    const HandbookPage* const page = handbook.find("messages");
    ASSERT_NE(page, nullptr);
    for (const MessageCodeInfo& info : message_codes) {
      EXPECT_THAT(page->markdown, HasSubstr("- `" + std::string(info.code) + "` (")) << language;
    }
  }
}

}  // namespace
}  // namespace feedscope
