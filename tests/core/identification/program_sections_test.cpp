#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/identification/section_times.h"

namespace feedscope {
namespace {

SectionLines lines_of(const std::string& section, const std::string& program) {
  return ProgramSections(SourceText("part.nc", program)).lines_of({section, 1, 0.001, 7}, "times.csv");
}

constexpr const char* two_sections =
    "(SECTION 1 BEGINS)\nG1 X1\n(SECTION 1 ENDS)\nG4 P1 ; section 12 begins\nX2\nX3 (Section 12 ends)\n";

TEST(ProgramSections, AreBetweenTheirMarksWhateverTheCase) {
  EXPECT_EQ(lines_of("1", two_sections).first, 1);
  EXPECT_EQ(lines_of("1", two_sections).last, 3);
  EXPECT_EQ(lines_of("12", two_sections).first, 4);
  EXPECT_EQ(lines_of("12", two_sections).last, 6);
  EXPECT_EQ(lines_of("2-5", two_sections).first, 2) << "lines need no marks";
  EXPECT_EQ(lines_of("2-5", two_sections).last, 5);
}

TEST(ProgramSections, AreFromTheFirstMarkOn) {
  EXPECT_EQ(
      lines_of("3", "(SECTION 3 BEGINS)\nX1\n(SECTION 3 BEGINS)\n(SECTION 3 ENDS)\n(SECTION 3 ENDS)\n").first,
      1);
  EXPECT_EQ(lines_of("3", "(SECTION x) (SECTION 3 BEGINS)\n(SECTION 3 ENDS)\n").first, 1)
      << "the second on its line";
}

TEST(ProgramSections, ThatAreNotThereAreNamedWithTheirRow) {
  for (const char* section : {"2", "0", "5-3", "5-30", "first"}) {
    EXPECT_THAT([&] { lines_of(section, two_sections); },
                testing::ThrowsMessage<InputError>(testing::HasSubstr(
                    std::string("times.csv:7: part.nc has no section '") + section + "'")));
  }
  EXPECT_THROW(lines_of("1", "(SECTION 1 ENDS)\n(SECTION 1 BEGINS)\n"), InputError);
  EXPECT_THROW(lines_of("1", "(SECTION 1 BEGINS)\nX1\n"), InputError);
}

}  // namespace
}  // namespace feedscope
