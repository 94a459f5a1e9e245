#include "core/program/sinumerik/geometry/coordinate_value.h"

#include <gtest/gtest.h>

#include "core/program/text/read_fault.h"
#include "tests/core/program/sinumerik/part_bench.h"

namespace feedscope::sinumerik {
namespace {

struct Case {
  const char* text;
  double value;
  Reading reading;
  Across across = Across::modal;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.text;
}

class SinumerikCoordinateValue : public testing::TestWithParam<Case> {};

TEST_P(SinumerikCoordinateValue, IsReadAsItsFunctionSays) {
  PartBench bench;
  Scanner scanner(GetParam().text);
  const BlockWords::Value value = read_coordinate(bench.values, scanner, 5);
  EXPECT_EQ(value.value, GetParam().value);
  EXPECT_EQ(value.column, 5U);
  EXPECT_EQ(value.reading, GetParam().reading);
  EXPECT_EQ(value.across, GetParam().across);
}

INSTANTIATE_TEST_SUITE_P(Functions, SinumerikCoordinateValue,
                         testing::Values(Case{"-1.5 Y2", -1.5, Reading::modal},
                                         Case{"2*(1+2)", 6, Reading::modal},
                                         Case{"IC(1+1)", 2, Reading::incremental},
                                         Case{"ACN(90)", 90, Reading::negative},
                                         Case{"DIC(4)", 4, Reading::incremental, Across::diameter},
                                         Case{"RAC(4)", 4, Reading::absolute, Across::radius}));

TEST(SinumerikCoordinateValueTest, IsRefusedBeyondTheLargestNumber) {
  PartBench bench;
  Scanner scanner("IC(1EX9*2)");
  EXPECT_THROW(read_coordinate(bench.values, scanner, 1), ReadFault);
}

}  // namespace
}  // namespace feedscope::sinumerik
