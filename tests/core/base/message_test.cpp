#include "core/base/message.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace feedscope {
namespace {

TEST(Message, FormatsNumbersAsTheirPlacesSay) {
  const Message made =
      message(NC_("core", "{} of {:.3f} mm in {:02X}, {:.0f} and {:g}"), 7, 2.5, 10, 41.6, 0.25);
  EXPECT_EQ(made, "7 of 2.500 mm in 0A, 42 and 0.25");
  EXPECT_EQ(message(NC_("core", "{} {}"), 0.002F, std::size_t{3}), "0.002 3");
}

TEST(Message, TakesNumberedPlacesInAnyOrder) {
  const Message made = message(NC_("core", "{1} before {0:.1f}, {1} again"), 0.25, 'X');
  EXPECT_EQ(made, "X before 0.2, X again");
  EXPECT_EQ(made.arguments().size(), 2U);
}

TEST(Message, KeepsItsPatternAndEachArgument) {
  const Message inner = message(NC_("core", "axis {}"), 'X');
  const Message made = message(NC_("core", "{} moves to {:.1f} in {}"), inner, 2.0, std::string("part.nc"));
  EXPECT_EQ(made.text(), "{} moves to {:.1f} in {}");
  ASSERT_EQ(made.arguments().size(), 3U);
  EXPECT_EQ(made.arguments()[0], inner);
  EXPECT_EQ(made.arguments()[1].kind(), Message::Kind::number);
  EXPECT_EQ(made.arguments()[2].kind(), Message::Kind::written);
  EXPECT_EQ(made.english(), "axis X moves to 2.0 in part.nc");
}

/// Numbers in words of a program keep their decimal point in every language.
TEST(Message, KnowsNumbersThatAreWordsOfTheProgram) {
  const Message made =
      message(NC_("core", "F{} of {} mm, \"{}\", {}{}, AR={}"), 2.5, 2.5, 2.5, 'X', 2.5, 2.5);
  std::string kinds;
  for (const Message& argument : made.arguments()) {
    kinds += argument.kind() == Message::Kind::number ? 'n' : 'w';
  }
  EXPECT_EQ(kinds, "wnwwww");
}

TEST(Message, WritesBracesOfAPatternOnce) {
  EXPECT_EQ(message(NC_("core", "write {{ value = {} }}"), 5), "write { value = 5 }");
  EXPECT_EQ(Message(NC_("core", "'{{' without '}}'")), "'{{' without '}}'") << "no arguments, no places";
}

/// Braces in a name are not places.
TEST(Message, NeverLooksForPlacesInItsArguments) {
  EXPECT_EQ(message(NC_("core", "{} and {}"), std::string_view("{}"), std::string_view("{0}")), "{} and {0}");
}

TEST(Message, ListsWithCommasAndAnd) {
  const std::array<Message, 3> all{Message::as_written("A"), Message::as_written("B"),
                                   Message::as_written("C")};
  EXPECT_EQ(listed(std::span(all).first(0)), "");
  EXPECT_EQ(listed(std::span(all).first(1)), "A");
  EXPECT_EQ(listed(std::span(all).first(2)), "A and B");
  EXPECT_EQ(listed(all), "A, B and C");
  EXPECT_EQ(enumerated(all), "A, B, C");
}

TEST(Message, PutsAPlaceInFront) {
  EXPECT_EQ(at_place("mill.toml:1:6", NC_("core", "the file")), "mill.toml:1:6: the file");
}

TEST(Message, IsEqualByWhatItSays) {
  EXPECT_EQ(message(NC_("core", "line {}"), 5), message(NC_("core", "line {}"), 5));
  EXPECT_NE(message(NC_("core", "line {}"), 5), message(NC_("core", "line {}"), 6));
  EXPECT_NE(message(NC_("core", "line {}"), 5), Message::as_written("line 5")) << "that has no translation";
  EXPECT_TRUE(Message().empty());
  std::ostringstream stream;
  stream << message(NC_("core", "line {}"), 5);
  EXPECT_EQ(stream.str(), "line 5");
}

TEST(Message, SaysWhyTheSystemRefuses) {
  EXPECT_EQ(reason_of(std::make_error_code(std::errc::no_such_file_or_directory)),
            "No such file or directory");
  EXPECT_EQ(reason_of(std::make_error_code(std::errc::permission_denied)).kind(), Message::Kind::pattern);
  EXPECT_EQ(reason_of(std::make_error_code(std::errc::broken_pipe)).kind(), Message::Kind::written);
}

}  // namespace
}  // namespace feedscope
