#include "core/trace/trace_columns.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/base/error.h"

namespace feedscope {
namespace {

using testing::HasSubstr;

std::string refused(const std::string& specification) {
  try {
    parse_trace_columns(specification);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(TraceColumns, SaysOfEachQuantityColumnUnitAndSign) {
  const TraceColumns columns = parse_trace_columns(
      "time=1:ms, x=3:-um, feed=Speed:m/min, separator=semicolon, decimal=comma, rate=500, skip=2");
  EXPECT_EQ(columns.of(TraceQuantity::time)->column, "1");
  EXPECT_DOUBLE_EQ(columns.of(TraceQuantity::time)->factor, 1e-3);
  EXPECT_DOUBLE_EQ(columns.of(TraceQuantity::x)->factor, -1e-3);
  EXPECT_EQ(columns.of(TraceQuantity::feed)->column, "Speed");
  EXPECT_DOUBLE_EQ(columns.of(TraceQuantity::feed)->factor, 1000.0 / 60);
  EXPECT_FALSE(columns.of(TraceQuantity::y));
  EXPECT_EQ(columns.separator, ';');
  EXPECT_EQ(columns.decimal, ',');
  EXPECT_DOUBLE_EQ(columns.period, 0.002);
  EXPECT_EQ(columns.skip, 2U);
}

TEST(TraceColumns, AnOffsetIsAddedInTheUnitOfTheColumn) {
  const TraceColumns columns = parse_trace_columns("x=2:-mm:12.5,y=Pos:3:inch:-1,z=4::0.5,actual_x=5:um");
  EXPECT_EQ(columns.of(TraceQuantity::x)->column, "2");
  EXPECT_EQ(columns.of(TraceQuantity::x)->offset, 12.5);
  EXPECT_LT(columns.of(TraceQuantity::x)->factor, 0);
  EXPECT_EQ(columns.of(TraceQuantity::y)->column, "Pos:3");
  EXPECT_EQ(columns.of(TraceQuantity::y)->offset, -1);
  EXPECT_EQ(columns.of(TraceQuantity::z)->column, "4");
  EXPECT_FALSE(columns.of(TraceQuantity::z)->unit_given);
  EXPECT_EQ(columns.of(TraceQuantity::z)->offset, 0.5);
  EXPECT_EQ(columns.of(TraceQuantity::actual_x)->offset, 0);
  EXPECT_THROW(parse_trace_columns("time=1:ms:5"), InputError);
}

TEST(TraceColumns, KnowsItsPresets) {
  for (const TracePreset& preset : trace_presets()) {
    EXPECT_TRUE(parse_trace_columns(std::string(preset.name)).any()) << preset.name;
  }
}

TEST(TraceColumns, MoreMayFollowAPreset) {
  for (const TracePreset& preset : trace_presets()) {
    const TraceColumns columns = parse_trace_columns(fmt::format("{}, rate=500,z=7:um", preset.name));
    EXPECT_DOUBLE_EQ(columns.period, 0.002) << preset.name;
    EXPECT_EQ(columns.of(TraceQuantity::z)->column, "7");
    EXPECT_EQ(columns.of(TraceQuantity::x)->column,
              parse_trace_columns(std::string(preset.name)).of(TraceQuantity::x)->column);
  }
  EXPECT_EQ(parse_trace_columns("linuxcnc").period, 0) << "the machine may say it";
  EXPECT_THAT(refused("linuxnc,rate=500"), HasSubstr("'linuxnc' is no preset of columns; known: linuxcnc"));
  EXPECT_THAT(refused("linuxcnc,500"), HasSubstr("'500' is not KEY=VALUE"));
}

TEST(TraceColumns, RefusesWhatItDoesNotKnowAndSaysWhatItDoes) {
  EXPECT_THAT(refused("linuxnc"), HasSubstr("'linuxnc' is no preset of columns; known: linuxcnc"));
  EXPECT_THAT(refused("tme=1"), HasSubstr("unknown key 'tme'; did you mean 'time'?"));
  EXPECT_THAT(refused("x=2:kg"), HasSubstr("unit 'kg' of x is not known; known: mm, um, nm, m, in, inch"));
  EXPECT_THAT(refused("x="), HasSubstr("x= needs the number or the name of a column"));
  EXPECT_THAT(refused("x=1,y"), HasSubstr("'y' is not KEY=VALUE"));
  EXPECT_THAT(refused("rate=0"), HasSubstr("rate=0 must be a number from"));
  EXPECT_THAT(refused("separator=dot"), HasSubstr("must be tab, comma, semicolon or blank"));
}

struct Title {
  const char* text;
  TraceQuantity quantity;
  const char* unit;
};

class TraceTitles : public testing::TestWithParam<Title> {};

TEST_P(TraceTitles, AreRecognised) {
  const NamedColumn named = recognise_column(GetParam().text);
  ASSERT_TRUE(named.quantity.has_value());
  EXPECT_EQ(*named.quantity, GetParam().quantity);
  EXPECT_EQ(named.unit, GetParam().unit);
}

INSTANTIATE_TEST_SUITE_P(Known, TraceTitles,
                         testing::Values(Title{"time_s", TraceQuantity::time, "s"},
                                         Title{"Zeit [ms]", TraceQuantity::time, "ms"},
                                         Title{"X_mm", TraceQuantity::x, "mm"},
                                         Title{"Axis Y1 set position (um)", TraceQuantity::y, "um"},
                                         Title{"Z", TraceQuantity::z, ""},
                                         Title{"MX1 Pos. setpoint", TraceQuantity::x, ""},
                                         Title{"feed_mm_min", TraceQuantity::feed, "mm/min"},
                                         Title{"Block number", TraceQuantity::line, ""}));

TEST(TraceTitles, OfOtherThingsAreNot) {
  for (const char* title : {"following_error_x_um", "X torque", "vx_mm_min", "spindle", "", "Y velocity",
                            "programmed_feed_mm_min"}) {
    EXPECT_FALSE(recognise_column(title).quantity) << title;
  }
  EXPECT_GT(recognise_column("X setpoint").rank, recognise_column("X actual").rank);
}

}  // namespace
}  // namespace feedscope
