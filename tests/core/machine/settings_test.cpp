#include "core/machine/settings.h"

#include <gmock/gmock.h>

#include "core/base/error.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const SettingSpec& spec_of(const std::string& key) {
  for (const SettingSpec& spec : common_settings()) {
    if (spec.key == key) {
      return spec;
    }
  }
  throw InputError("no spec " + key);
}

SettingSpec choice_spec() {
  SettingSpec spec;
  spec.key = "reading";
  spec.choices = {"corrected", "published"};
  return spec;
}

double parsed(const std::string& key, const std::string& text) {
  return std::get<double>(parse_setting(spec_of(key), text));
}

auto fails_with(const std::string& message) {
  return ThrowsMessage<InputError>(HasSubstr(message));
}

TEST(CommonSettings, HaveTitleExplanationAndAFallbackInBounds) {
  EXPECT_EQ(common_settings().size(), 11U + machine_settings().size());
  for (const SettingSpec& spec : common_settings()) {
    EXPECT_FALSE(spec.title.empty()) << spec.key;
    EXPECT_FALSE(spec.explanation.empty()) << spec.key;
    const SettingValue fallback =
        spec.choices.empty() ? SettingValue(spec.fallback) : SettingValue(spec.choices.front());
    EXPECT_NO_THROW(check_setting(spec, fallback, "")) << spec.key;
  }
}

TEST(MachineSettings, MayBeMissingAndNoOthersMay) {
  EXPECT_EQ(machine_settings().size(), 20U);
  for (const SettingSpec& spec : common_settings()) {
    if (spec.optional) {
      EXPECT_EQ(parse_setting(spec, ""), SettingValue(std::string())) << spec.key;
    } else if (spec.choices.empty()) {
      EXPECT_THROW(parse_setting(spec, ""), InputError) << spec.key;
    }
  }
  for (const SettingSpec& spec : machine_settings()) {
    EXPECT_TRUE(spec.optional) << spec.key;
  }
  Settings settings;
  settings.set("home_z_mm", 0.0);
  EXPECT_TRUE(settings.has("home_z_mm"));
  settings.set("home_z_mm", std::string());
  EXPECT_FALSE(settings.has("home_z_mm"));
}

TEST(ParseSetting, TakesPointAndComma) {
  EXPECT_EQ(parsed("contour_tolerance_mm", "0.05"), 0.05);
  EXPECT_EQ(parsed("contour_tolerance_mm", "0,05"), 0.05);
  EXPECT_EQ(parsed("contour_tolerance_mm", "+5e-2"), 0.05);
}

TEST(ParseSetting, SaysWhatToWriteInsteadOfAnAmbiguousComma) {
  EXPECT_THAT(
      [] { parse_setting(spec_of("contour_tolerance_mm"), "1,000"); },
      fails_with("contour_tolerance_mm = '1,000': the comma could be a decimal or a thousands separator; "
                 "write 1.000 or 1000"));
}

TEST(ParseSetting, NamesNoBoundsWhereThereAreNone) {
  SettingSpec any;
  any.key = "any";
  any.minimum = -std::numeric_limits<double>::infinity();
  EXPECT_THAT([&] { parse_setting(any, "x"); }, fails_with("any = 'x' is not a number; it must be finite"));
}

TEST(ParseSetting, NamesKeyValueAndBoundsOfWhatIsNoNumber) {
  for (const std::string text : {"", "abc", "1.2.3", "1 mm", "0x10", "--1"}) {
    EXPECT_THAT([&] { parse_setting(spec_of("contour_tolerance_mm"), text); },
                fails_with("contour_tolerance_mm = '" + text +
                           "' is not a number; it must be 0, or at least 0.000001 mm and at most 10 mm"));
  }
}

TEST(ParseSetting, RejectsNumbersOutOfBounds) {
  for (const std::string text : {"-1e-9", "-1", "10.1", "nan", "inf", "-inf", "5e-324", "9e-7"}) {
    EXPECT_THAT([&] { parse_setting(spec_of("contour_tolerance_mm"), text); },
                fails_with("it must be 0, or at least 0.000001 mm and at most 10 mm"))
        << text;
  }
  EXPECT_EQ(parsed("contour_tolerance_mm", "0"), 0);
  EXPECT_EQ(parsed("contour_tolerance_mm", "0.000001"), 1e-6);
  EXPECT_EQ(parsed("contour_tolerance_mm", "10"), 10);
  EXPECT_THAT([] { parse_setting(spec_of("interpolation_period_s"), "0"); },
              fails_with("it must be above 0 s and at most 1 s"));
}

TEST(ParseSetting, KeepsCountsWhole) {
  EXPECT_EQ(parsed("lookahead_blocks", "8"), 8);
  EXPECT_THAT([] { parse_setting(spec_of("lookahead_blocks"), "8.5"); },
              fails_with("lookahead_blocks = 8.5 is out of bounds; it must be a whole number at least 1"));
}

TEST(ParseSetting, NamesTheChoices) {
  EXPECT_EQ(std::get<std::string>(parse_setting(choice_spec(), "published")), "published");
  EXPECT_THAT(
      [] { parse_setting(choice_spec(), "publishd"); },
      fails_with("reading = 'publishd' is not a valid choice; it must be one of: corrected, published"));
}

TEST(CheckSetting, PutsThePlaceInFront) {
  EXPECT_THAT([] { check_setting(spec_of("tangential_share"), 2.0, "a.toml:3:4"); },
              ThrowsMessage<InputError>(
                  "a.toml:3:4: tangential_share = 2 is out of bounds; it must be above 0 and at most 1"));
  EXPECT_THAT([] { check_setting(spec_of("tangential_share"), std::string("x"), ""); },
              fails_with("is text"));
  EXPECT_THAT([] { check_setting(choice_spec(), 2.0, ""); }, fails_with("'2' is not a valid choice"));
}

TEST(NearestWithin, KeepsBoundsAndTheGapAboveZero) {
  const SettingSpec tolerance = spec_of("contour_tolerance_mm");
  EXPECT_EQ(nearest_within(tolerance, -1), 0);
  EXPECT_EQ(nearest_within(tolerance, 0), 0);
  EXPECT_EQ(nearest_within(tolerance, 1e-9), 1e-6);
  EXPECT_EQ(nearest_within(tolerance, 0.02), 0.02);
  EXPECT_EQ(nearest_within(tolerance, 11), 10);
}

TEST(PlainText, HasNoExponentForSmallNumbers) {
  EXPECT_EQ(plain_text(1e-6), "0.000001");
  EXPECT_EQ(plain_text(0.00001), "0.00001");
  EXPECT_EQ(plain_text(0.0001), "0.0001");
  EXPECT_EQ(plain_text(0), "0");
  EXPECT_EQ(plain_text(1e9), "1000000000");
  EXPECT_EQ(plain_text(5e-324), "5e-324");
}

TEST(Settings, NamesKeyOfAbsentValueOrOtherType) {
  Settings settings;
  settings.set("a", 1.5);
  settings.set("b", std::string("text"));
  EXPECT_TRUE(settings.has("a"));
  EXPECT_EQ(settings.number("a"), 1.5);
  EXPECT_EQ(settings.text("b"), "text");
  EXPECT_THAT([&] { settings.number("c"); }, fails_with("setting 'c' has no value"));
  EXPECT_THAT([&] { settings.text("c"); }, fails_with("setting 'c' has no value"));
  EXPECT_THAT([&] { settings.number("b"); }, fails_with("setting 'b' is the text 'text'"));
  EXPECT_THAT([&] { settings.text("a"); }, fails_with("setting 'a' is the number 1.5"));
}

}  // namespace
}  // namespace feedscope
