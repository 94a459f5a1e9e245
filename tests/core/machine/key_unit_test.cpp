#include "core/machine/key_unit.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

double read(const char* text, const char* unit) {
  return typed_in_unit(text, unit).value.value_or(-1);
}

TEST(KeyUnit, NumbersAreInTheUnitOfTheKeyOrInOneOfDataSheets) {
  EXPECT_DOUBLE_EQ(read("5", "m/s2"), 5);
  EXPECT_DOUBLE_EQ(read("0.5 g", "m/s2"), 4.903325);
  EXPECT_DOUBLE_EQ(read("0,5g", "m/s2"), 4.903325) << "a comma and no blank";
  EXPECT_DOUBLE_EQ(read("4000 mm/s2", "m/s2"), 4);
  EXPECT_DOUBLE_EQ(read("4 m/s²", "m/s2"), 4);
  EXPECT_DOUBLE_EQ(read("20 m/s3", "m/s3"), 20);
  EXPECT_DOUBLE_EQ(read("60000 mm/s3", "m/s3"), 60);
  EXPECT_DOUBLE_EQ(read("5 g/s", "m/s3"), 49.03325);
  EXPECT_DOUBLE_EQ(read("500 mm/s", "m/min"), 30);
  EXPECT_DOUBLE_EQ(read("1 m/s", "m/min"), 60);
  EXPECT_DOUBLE_EQ(read("30 1/s", "1/s"), 30);
  EXPECT_DOUBLE_EQ(read("1.8 (m/min)/mm", "1/s"), 30);
  EXPECT_DOUBLE_EQ(read("0.01 mm", "um"), 10);
}

TEST(KeyUnit, AUnitOfAnotherQuantityIsNoNumber) {
  for (const auto& [text, unit] :
       {std::pair("0.5 g", "m/s3"), std::pair("20 m/s3", "m/s2"), std::pair("301/s", "1/s"),
        std::pair("g", "m/s2"), std::pair("5 kg", "m/s2"), std::pair("5 mm", ""), std::pair("", "m/s2")}) {
    EXPECT_FALSE(typed_in_unit(text, unit).value.has_value()) << text << " as " << unit;
  }
}

TEST(KeyUnit, TheProblemWithAnotherUnitNamesThoseThatAreKnown) {
  EXPECT_EQ(typed_in_unit("0.5 lb", "m/s2").problem,
            "unknown unit 'lb'; write the number in one of: m/s2, m/s², mm/s2, g");
  EXPECT_EQ(typed_in_unit("1e3 kg", "ms").problem, "unknown unit 'kg'; write the number in one of: ms, s");
  for (const auto& [text, unit] : {std::pair("g", "m/s2"), std::pair("5 mm", ""), std::pair("", "m/s2")}) {
    EXPECT_EQ(typed_in_unit(text, unit).problem, "") << text;
  }
}

/// The unit that is shown beside is one that can be typed.
TEST(KeyUnit, TheUnitOfDataSheetsGoesThereAndBack) {
  for (const char* unit : {"m/s2", "1/s"}) {
    const DataSheetUnit other = data_sheet_unit(unit);
    ASSERT_FALSE(other.name.empty());
    EXPECT_DOUBLE_EQ(read(("1 " + std::string(other.name)).c_str(), unit), other.factor);
  }
  EXPECT_TRUE(data_sheet_unit("um").name.empty());
}

}  // namespace
}  // namespace feedscope
