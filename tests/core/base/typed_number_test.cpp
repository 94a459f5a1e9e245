#include "core/base/typed_number.h"

#include <gmock/gmock.h>

#include <random>

namespace feedscope {
namespace {

using testing::HasSubstr;

TEST(TypedNumber, HasPointOrCommaAsDecimalSign) {
  for (const char* text : {"0.05", "0,05", "+0,05", "5e-2", "5,0e-2", ".05", ",05"}) {
    EXPECT_EQ(typed_number(text).value, 0.05) << text;
  }
  EXPECT_EQ(typed_number("-12,5").value, -12.5);
  EXPECT_EQ(typed_number("1.000").value, 1) << "a point is always the decimal sign";
}

TEST(TypedNumber, IsRefusedWhereACommaCouldGroupThousands) {
  for (const char* text : {"1,000", "12,345", "999,999", "-1,000", "4,995", "1,000e3"}) {
    const TypedNumber number = typed_number(text);
    EXPECT_FALSE(number.value) << text;
    EXPECT_THAT(number.problem.english(), HasSubstr("the comma could be a decimal or a thousands separator"))
        << text;
  }
  EXPECT_THAT(typed_number("4,995").problem.english(), HasSubstr("write 4.995 or 4995"));
  for (const auto& [text, plain] : {std::pair{"1,000,000", "1000000"},
                                    {"1.000,5", "1000.5"},
                                    {"1,000.5", "1000.5"},
                                    {"-1.234.567,25", "-1234567.25"}}) {
    EXPECT_THAT(typed_number(text).problem.english(), HasSubstr("no thousands separators; write ")) << text;
    EXPECT_THAT(typed_number(text).problem.english(), testing::EndsWith(plain)) << text;
  }
}

TEST(TypedNumber, AListIsNotTakenForGroupsOfThousands) {
  for (const char* text :
       {"0.002,0.01", "0.002,0.01,0.05,0.1", "1,2,3", "10.5,20.5", "1,000,00", "0,000,000"}) {
    EXPECT_EQ(typed_number(text).problem, "one number is expected here, not several") << text;
  }
  EXPECT_EQ(typed_number("0.01,fine").problem.english(), "");
}

/// Over all ways to write a number with one comma: it is the number that the comma as a point gives, or
/// refused; and it is refused exactly where leaving out the comma gives a number that people group so.
TEST(TypedNumber, NeverTakesAFactor) {
  std::mt19937 random(1);
  std::size_t refused = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::string whole = std::to_string(random() % (random() % 2 == 0 ? 10 : 20000));
    std::string decimals;
    for (std::size_t k = 1 + random() % 6; k > 0; --k) {
      decimals += static_cast<char>('0' + random() % 10);
    }
    const TypedNumber number = typed_number(whole + "," + decimals);
    const bool grouped = whole != "0" && whole.size() <= 3 && decimals.size() == 3;
    EXPECT_EQ(number.value.has_value(), !grouped) << whole << "," << decimals;
    if (number.value) {
      EXPECT_EQ(*number.value, *typed_number(whole + "." + decimals).value);
    }
    refused += grouped ? 1 : 0;
  }
  EXPECT_GT(refused, 1000u);
}

TEST(TypedNumber, IsNothingElse) {
  for (const char* text : {"", ",", "abc", "1.2.3", "1 mm", "0x10", "--1", "a,b", "1,2x", "1,2,", "1,.,3"}) {
    EXPECT_FALSE(typed_number(text).value) << text;
    EXPECT_EQ(typed_number(text).problem.english(), "") << text;
  }
}

TEST(TypedListNumber, RefusesEveryComma) {
  EXPECT_EQ(typed_list_number("0.05").value, 0.05);
  EXPECT_THAT(typed_list_number("0,05").problem.english(),
              HasSubstr("write 0.05 for one value, \"0;05\" in quotes"));
  EXPECT_FALSE(typed_list_number("2,").value);
}

TEST(TypedListNumber, WithAPointTheCommaCanOnlySeparate) {
  EXPECT_EQ(typed_list_number("0.01,0.05").problem,
            "a comma does not separate values here; write \"0.01;0.05\" in quotes");
}

}  // namespace
}  // namespace feedscope
