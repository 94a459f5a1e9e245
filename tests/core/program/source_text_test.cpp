#include "core/program/text/source_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace feedscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> lines_of(std::string text) {
  const SourceText source("test.nc", std::move(text));
  std::vector<std::string> lines;
  for (std::uint32_t number = 1; number <= source.line_count(); ++number) {
    lines.emplace_back(source.line(number));
  }
  return lines;
}

std::string message_of(const std::filesystem::path& path) {
  try {
    SourceText::from_file(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

class SourceFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& content) const {
    std::ofstream(path_, std::ios::binary) << content;
    return path_;
  }
  void TearDown() override { std::filesystem::remove(path_); }

 private:
  std::filesystem::path path_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".nc");
};

TEST(SourceText, SplitsEveryKindOfLineEnd) {
  EXPECT_THAT(lines_of("a\nb\n"), ElementsAre("a", "b"));
  EXPECT_THAT(lines_of("a\r\nb\r\n"), ElementsAre("a", "b"));
  EXPECT_THAT(lines_of("a\rb\r"), ElementsAre("a", "b"));
  EXPECT_THAT(lines_of("a\r\r\nb\r\r\nc"), ElementsAre("a", "b", "c"));
  EXPECT_THAT(lines_of("a\nb\r\nc\rd"), ElementsAre("a", "b", "c", "d"));
}

TEST(SourceText, KeepsBlankLines) {
  EXPECT_THAT(lines_of("\n\na\n"), ElementsAre("", "", "a"));
  EXPECT_THAT(lines_of("a\r\rb"), ElementsAre("a", "", "b"));
  EXPECT_THAT(lines_of("\r\n\r\nb"), ElementsAre("", "", "b"));
  EXPECT_THAT(lines_of("\r"), ElementsAre(""));
  EXPECT_THAT(lines_of("\r\r\r\n"), ElementsAre("", ""));
}

TEST(SourceText, LastLineNeedsNoEnd) {
  EXPECT_THAT(lines_of("a"), ElementsAre("a"));
  EXPECT_THAT(lines_of(""), ElementsAre());
}

TEST(SourceText, LeavesOutAByteOrderMark) {
  EXPECT_THAT(lines_of("\xEF\xBB\xBFG1 X1\nG0"), ElementsAre("G1 X1", "G0"));
  EXPECT_THAT(lines_of("\xEF\xBB\xBF"), ElementsAre());
}

TEST(SourceText, LinesOutOfRangeAreEmpty) {
  const SourceText source("test.nc", "a\nb\n");
  EXPECT_EQ(source.line(0), "");
  EXPECT_EQ(source.line(3), "");
}

TEST(SourceText, AMillionReturnsWithoutALineFeedAreAMillionLines) {
  const SourceText source("test.nc", std::string(1000000, '\r'));
  EXPECT_EQ(source.line_count(), 1000000U);
}

TEST_F(SourceFile, KeepsTheTextAsWritten) {
  const SourceText source = SourceText::from_file(write("G0 X1\r\nG1 X2"));
  EXPECT_EQ(source.text(), "G0 X1\r\nG1 X2");
  EXPECT_EQ(source.line(2), "G1 X2");
  EXPECT_THAT(source.name(), HasSubstr("KeepsTheTextAsWritten.nc"));
}

TEST_F(SourceFile, MayBeEmpty) {
  EXPECT_EQ(SourceText::from_file(write("")).line_count(), 0U);
}

TEST_F(SourceFile, ThatIsNoTextOrHasAnEndlessLineIsRefused) {
  EXPECT_THAT(message_of(write("G0 X1" + std::string(40, '\0') + "M30\n")),
              HasSubstr("is not a text file (it has 40 control characters)"));
  EXPECT_THAT(message_of(write("\xFF\xFEG")), HasSubstr("is not a text file (it is UTF-16)"));
  EXPECT_THAT(message_of(write("G0 X1\n" + std::string(SourceText::longest_line + 1, ' '))),
              HasSubstr(":2: the line is 10000001 bytes long"));
}

TEST(SourceText, MissingFileIsRefused) {
  EXPECT_EQ(message_of("no/such/part.nc"), "no/such/part.nc: does not exist; check the path");
}

TEST(SourceText, DirectoryIsRefused) {
  EXPECT_THAT(message_of(testing::TempDir()), HasSubstr("is a directory; give the NC program inside it"));
}

TEST(SourceText, EndlessBinaryDeviceIsRefused) {
  EXPECT_THAT(message_of("/dev/zero"), HasSubstr("is not a text file"));
}

TEST(SourceText, UnreadableFileIsRefused) {
  EXPECT_THAT(message_of("/proc/self/mem"), HasSubstr("cannot be read: "));
}

TEST(SourceText, ControlCharactersOfTapesAndSerialLinesBecomeBlanks) {
  const SourceText tape("t", std::string(500, '\0') + "\x11G1 X1\x7F\nM30\n\x13\x1A");
  EXPECT_EQ(tape.noise_count(), 504U);
  EXPECT_TRUE(tape.line(1).ends_with(" G1 X1 "));
  EXPECT_EQ(tape.line(2), "M30");
}

TEST(SourceText, TellsUtf8FromLatin1) {
  EXPECT_EQ(SourceText("t", "G1 (Fr\xC3\xA4ser \xE2\x82\xAC)").encoding(), Encoding::utf8);
  EXPECT_EQ(SourceText("t", "G1 (Fr\xE4ser)").encoding(), Encoding::latin1);
  EXPECT_EQ(SourceText("t", "G1 (\xC3").encoding(), Encoding::latin1) << "a sequence cut short";
}

}  // namespace
}  // namespace feedscope
