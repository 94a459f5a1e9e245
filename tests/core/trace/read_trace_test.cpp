#include "core/trace/read_trace.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "core/base/error.h"

namespace feedscope {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Twenty rows, X = 10 i, Y = -i, at i milliseconds.
std::string table(const std::string& head, const std::string& row, const std::string& last = "") {
  std::string text = head;
  for (int i = 0; i < 20; ++i) {
    text += fmt::format(fmt::runtime(row), fmt::arg("t", i * 0.001), fmt::arg("ms", i),
                        fmt::arg("n", 500 + i), fmt::arg("x", 10.25 * i), fmt::arg("y", -0.5 * i));
  }
  return text + last;
}

std::string with_commas(std::string text) {
  std::ranges::replace(text, '.', ',');
  return text;
}

void expect_table(const Trace& trace) {
  ASSERT_EQ(trace.size(), 20U);
  EXPECT_NEAR(trace.period, 1e-3, 1e-12);
  EXPECT_NEAR(trace.time[19], 0.019, 1e-12);
  ASSERT_TRUE(trace.has(0) && trace.has(1));
  EXPECT_NEAR(trace.place[0][19], 10.25 * 19, 1e-9);
  EXPECT_NEAR(trace.place[1][19], -0.5 * 19, 1e-9);
}

std::string codes(const Trace& trace) {
  std::string all;
  for (const Diagnostic& note : trace.notes) {
    all += note.code + fmt::format(":{} ", note.line);
  }
  return all;
}

std::string refusal(const std::string& text, const TraceColumns& columns = {}) {
  try {
    parse_trace(text, "t.csv", columns);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

TEST(ReadTrace, FindsSeparatorDecimalMarkAndUnits) {
  expect_table(parse_trace(table("time_s,x_mm,y_mm\n", "{t},{x},{y}\n"), "t.csv"));
  expect_table(parse_trace(table("Zeit [ms];X [mm];Y [mm]\r\n", "{ms};{x};{y}\r\n"), "t.csv"));
  expect_table(
      parse_trace(with_commas(table("Zeit [s];X [mm];Y [mm]\n", "{t:.3f};{x:.2f};{y:.2f}\n")), "t.csv"));
  expect_table(parse_trace(table("# t x y\n", "{t} {x} {y}\n"), "t.csv"));
  expect_table(parse_trace(table("\xEF\xBB\xBFt\tX\tY\ns\tmm\tmm\n", "{t}\t{x}\t{y}\n"), "t.csv"));
  EXPECT_THAT(parse_trace(table("time_s,x_mm,y_mm\n", "{t},{x},{y}\n"), "t.csv").notes, IsEmpty());
}

TEST(ReadTrace, ReadsNumbersInQuotesWithTheSeparatorAsDecimalMark) {
  const std::string quoted = with_commas(table("", "\"{t:.3f}\"|\"{x:.2f}\"|\"{y:.2f}\"\n"));
  const auto with_separator = [&](char separator) {
    std::string text = "\"Zeit [s]\"|\"X [mm]\"|\"Y [mm]\"\n" + quoted;
    std::ranges::replace(text, '|', separator);
    return text;
  };
  for (const char separator : {',', ';', '\t'}) {
    SCOPED_TRACE(separator);
    const Trace trace = parse_trace(with_separator(separator), "t.csv");
    expect_table(trace);
    EXPECT_THAT(trace.notes, IsEmpty());
  }
  // Titles with the separator inside; quotes around some fields alone.
  expect_table(parse_trace(with_commas(table("t [s],\"X [mm], set\",\"Y [mm], set\"\n",
                                             "\"{t:.3f}\", \"{x:.2f}\" ,\"{y:.2f}\"\n")),
                           "t.csv"));
}

TEST(ReadTrace, SaysThatActualPositionsAreUsedWhereThereAreNoOthers) {
  const Trace actual = parse_trace(table("time_s,actual_x_mm,actual_y_mm\n", "{t},{x},{y}\n"), "t.csv");
  expect_table(actual);
  EXPECT_EQ(codes(actual), "trace-actual:0 ");
  EXPECT_THAT(actual.notes[0].message.english(), HasSubstr("no set positions of X, Y"));
  const Trace one = parse_trace(table("time_s,x_mm,actual_y_mm\n", "{t},{x},{y}\n"), "t.csv");
  EXPECT_THAT(one.notes[0].message.english(), HasSubstr("no set positions of Y:"));
  // Whoever names the columns knows.
  EXPECT_THAT(parse_trace(table("time_s,actual_x_mm,actual_y_mm\n", "{t},{x},{y}\n"), "t.csv",
                          parse_trace_columns("x=actual_x_mm,y=actual_y_mm"))
                  .notes,
              IsEmpty());
}

TEST(ReadTrace, KeepsActualPositionsBesideSetOnes) {
  const Trace both = parse_trace(
      table("time_s,x_mm,actual_x_mm,Y actual [um],following_error_x_um\n", "{t},{x},{y},{y},{x}\n"),
      "t.csv");
  ASSERT_TRUE(both.has_drive(0));
  EXPECT_NEAR(both.place[0][19], 10.25 * 19, 1e-9);
  EXPECT_EQ(both.actual[0][19], 1e3 * both.place[1][19]);
  // An axis whose actual position alone is recorded is laid beside the program.
  EXPECT_TRUE(both.has(1));
  EXPECT_FALSE(both.has_drive(1));
  EXPECT_THAT(both.columns, Contains("actual_x: column 3 'actual_x_mm' [mm]"));
}

TEST(ReadTrace, TakesActualPositionsAsAsked) {
  const Trace trace = parse_trace(table("time_s,a,b\n", "{t},{x},{y}\n"), "t.csv",
                                  parse_trace_columns("x=a:mm,actual_x=b:-um"));
  ASSERT_TRUE(trace.has_drive(0));
  EXPECT_NEAR(trace.actual[0][19], -1e-3 * parse_trace(table("time_s,y_mm\n", "{t},{y}\n"), "t").place[1][19],
              1e-12);
}

TEST(ReadTrace, CutsActualPositionsWithTheOthers) {
  const Trace trace = parse_trace(
      table(table("time_s,x_mm,actual_x_mm\n", "{t},{x},{y}\n"), "{t},{x},{y}\n", "0.020,3,4\n"), "t.csv");
  EXPECT_EQ(trace.size(), 21U);
  EXPECT_EQ(trace.actual[0].size(), 21U);
}

TEST(ReadTrace, ConvertsInches) {
  const Trace trace = parse_trace(table("time_s,x_inch\n", "{t},{x}\n"), "t.csv");
  EXPECT_NEAR(trace.place[0][19], 25.4 * 10.25 * 19, 1e-9);
  EXPECT_FALSE(trace.has(1));
}

TEST(ReadTrace, ReadsHalsamplerByItsValues) {
  const Trace trace = parse_trace(table("", "{n} {x} {y} 0.5 7 12.5\n"), "t.txt");
  expect_table(trace);
  EXPECT_EQ(trace.format, "LinuxCNC halsampler");
  EXPECT_EQ(trace.line[3], 7U);
  EXPECT_FLOAT_EQ(trace.feed[3], 12.5F);
  EXPECT_THAT(codes(trace), HasSubstr("trace-columns:1 trace-period:0"));
}

/// As it records without -t: a position that rises is no time.
TEST(ReadTrace, ReadsHalsamplerWithoutSampleNumbers) {
  std::string text;
  for (int i = 0; i < 200; ++i) {
    const double x = 5e-4 * i * i;  // speeds up
    text += fmt::format("{:.6f} {:.6f} 0.5 7 12.5\n", x, -x / 2);
  }
  const Trace trace = parse_trace(text, "t.txt");
  EXPECT_NEAR(trace.place[0][100], 5, 1e-9);
  EXPECT_NEAR(trace.place[1][100], -2.5, 1e-9);
  EXPECT_EQ(trace.line[100], 7U);
  EXPECT_NEAR(trace.period, 1e-3, 1e-12);
}

/// Rows of a motion at 100 mm/s, one each millisecond; `change` may move a place [mm].
std::string even_motion(const std::function<double(int)>& change) {
  std::string text = "time_s,x_mm\n";
  for (int i = 0; i < 100; ++i) {
    text += fmt::format("{:.3f},{:.4f}\n", i * 1e-3, 0.1 * i + change(i));
  }
  return text;
}

TEST(ReadTrace, SaysWhereSamplesAreMissingWithoutAGapInTheTimes) {
  const Trace trace = parse_trace(even_motion([](int i) { return i >= 50 ? 40.0 : 0; }), "t.csv");
  EXPECT_EQ(codes(trace), "trace-jump:52 ");
  EXPECT_THAT(trace.notes[0].message.english(), HasSubstr("jumps by 40.1 mm within 1 ms at 0.05 s"));
  EXPECT_THAT(trace.notes[0].hint.english(), HasSubstr("too short"));
  EXPECT_THAT(parse_trace(even_motion([](int) { return 0.0; }), "t.csv").notes, IsEmpty());
}

TEST(ReadTrace, SaysWhichSampleLiesBesideTheOthers) {
  const Trace trace = parse_trace(even_motion([](int i) { return i == 50 ? 500.0 : 0; }), "t.csv");
  EXPECT_EQ(codes(trace), "trace-jump:52 ");
  EXPECT_THAT(trace.notes[0].message.english(), HasSubstr("the sample at 0.05 s lies 500.1 mm beside"));
}

TEST(ReadTrace, TakesThePeriodAndColumnsThatAreGiven) {
  const Trace trace =
      parse_trace(table("", "{n} {y} {x}\n"), "t.txt", parse_trace_columns("number=1,x=3:-mm,rate=500"));
  EXPECT_NEAR(trace.period, 2e-3, 1e-12);
  EXPECT_NEAR(trace.place[0][19], -10.25 * 19, 1e-9);
  EXPECT_THAT(trace.notes, IsEmpty());
}

TraceColumns on_machine(const std::string& specification, double period) {
  TraceColumns columns = specification.empty() ? TraceColumns() : parse_trace_columns(specification);
  columns.machine_period = period;
  return columns;
}

TEST(ReadTrace, TakesTheRateFromTheOptionTheFileOrTheMachineInThisOrder) {
  const std::string timed = table("time_s,x_mm,y_mm\n", "{t},{x},{y}\n");
  const std::string untimed = table("", "{n} {x} {y} 0.5 7 12.5\n");
  const auto expect = [](const Trace& trace, double period, TraceClock clock, const std::string& said) {
    EXPECT_NEAR(trace.period, period, 1e-12);
    EXPECT_EQ(trace.clock, clock);
    EXPECT_EQ(codes(trace), said);
  };
  expect(parse_trace(timed, "t.csv", on_machine("rate=200", 4e-3)), 5e-3, TraceClock::option, "");
  expect(parse_trace(timed, "t.csv", on_machine("time=1:s,x=2,period=0.005", 4e-3)), 5e-3, TraceClock::option,
         "");
  expect(parse_trace(timed, "t.csv", on_machine("", 4e-3)), 1e-3, TraceClock::times, "");
  expect(parse_trace(untimed, "t.txt", on_machine("linuxcnc,rate=500", 4e-3)), 2e-3, TraceClock::option, "");
  expect(parse_trace(untimed, "t.txt", on_machine("linuxcnc", 4e-3)), 4e-3, TraceClock::machine,
         "trace-period:0 ");
  expect(parse_trace(untimed, "t.txt", on_machine("linuxcnc", 0)), 1e-3, TraceClock::assumed,
         "trace-period:0 ");
}

/// Rows of a halsampler: number, X, Y, Z, line and feed [mm/s]; around a circle at 50 mm/s, with stops.
std::string circle(double period, double feed_unit = 1) {
  std::string text;
  for (int i = 0; i < 2000; ++i) {
    const double s = 50 * period * (900 * (i / 1000) + std::min(i % 1000, 900));
    text += fmt::format("{} {:.6f} {:.6f} 0 7 {:.6f}\n", i, 20 * std::cos(s / 20), 20 * std::sin(s / 20),
                        feed_unit * (i % 1000 < 900 ? 50 : 0));
  }
  return text;
}

TEST(ReadTrace, SaysThatARateIsWrongThatItsFeedContradicts) {
  const auto columns = parse_trace_columns("linuxcnc,rate=1000");
  const Trace wrong = parse_trace(circle(2e-3), "t.txt", columns);
  ASSERT_EQ(codes(wrong), "trace-rate:0 ");
  EXPECT_THAT(wrong.notes[0].message.english(), HasSubstr("move at 200 % of the feed"));
  EXPECT_THAT(wrong.notes[0].hint.english(), HasSubstr("--columns linuxcnc,rate=500;"));
  const Trace slow = parse_trace(circle(0.5e-3), "t.txt", columns);
  ASSERT_EQ(codes(slow), "trace-rate:0 ");
  EXPECT_THAT(slow.notes[0].hint.english(), HasSubstr("rate=2000;"));
  EXPECT_EQ(codes(parse_trace(circle(1e-3), "t.txt", columns)), "");
  EXPECT_EQ(codes(parse_trace(circle(1e-3, 60), "t.txt", columns)), "")
      << "a feed in mm/min is no other rate";
}

TEST(ReadTrace, ReportsGapsWithTheirLine) {
  const Trace trace = parse_trace(table("time_s,x_mm\n", "{t},{x}\n", "0.050,1\n0.051,2\n"), "t.csv");
  EXPECT_EQ(trace.gaps, 1U);
  EXPECT_NEAR(trace.lost, 0.030, 1e-9);
  EXPECT_EQ(codes(trace), "trace-gap:22 ");
}

TEST(ReadTrace, SeesSamplesThatTheRecorderLost) {
  const Trace trace = parse_trace(table("", "{n} {x} {y}\n", "overrun\n530 1.5 2.5\n"), "t.txt");
  EXPECT_EQ(trace.gaps, 1U);
  EXPECT_THAT(codes(trace), HasSubstr("trace-row:21 "));
}

TEST(ReadTrace, KeepsTheLongestPartWhereTimeGoesBack) {
  const Trace trace =
      parse_trace(table(table("time_s,x_mm\n", "{t},{x}\n"), "{t},{x}\n", "0.020,3\n"), "t.csv");
  EXPECT_EQ(trace.size(), 21U);
  EXPECT_EQ(trace.time.front(), 0);
  EXPECT_EQ(codes(trace), "trace-time-back:22 trace-parts:22 ");
}

/// Times that jitter by more than a period are no new part each time.
TEST(ReadTrace, SkipsSamplesWhoseTimesJitterBack) {
  std::string text = "time_s,x_mm\n";
  for (int i = 0; i < 200; ++i) {
    text += fmt::format("{:.4f},{:.4f}\n", i * 1e-3 + (i % 20 == 19 ? 1.5e-3 : 0), 0.1 * i);
  }
  const Trace trace = parse_trace(text, "t.csv");
  EXPECT_EQ(trace.size(), 191U);
  EXPECT_EQ(trace.place[0].back(), 19.9);
  EXPECT_THAT(codes(trace), HasSubstr("trace-time-jitter:22"));
  EXPECT_THAT(codes(trace), Not(HasSubstr("trace-parts")));
}

TEST(ReadTrace, SaysWhatAnUnknownTimeUnitWasTakenFor) {
  const Trace trace = parse_trace(table("t,x\n", "{ms},{x}\n"), "t.csv");
  EXPECT_NEAR(trace.period, 1e-3, 1e-12);
  EXPECT_THAT(codes(trace), HasSubstr("trace-time-unit"));
}

TEST(ReadTrace, WarnsOfCoarseSampling) {
  const Trace trace =
      parse_trace(table("t,x\n", "{ms},{x}\n"), "t.csv", parse_trace_columns("number=t,x=x,rate=50"));
  EXPECT_NEAR(trace.period, 0.02, 1e-12);
  EXPECT_THAT(codes(trace), HasSubstr("trace-coarse"));
}

TEST(ReadTrace, RefusesWhatIsNoTraceAndSaysWhy) {
  EXPECT_THAT(refusal(""), HasSubstr("'t.csv' is no trace"));
  EXPECT_THAT(refusal("G1 X20\nhello\n"), HasSubstr("'t.csv' is no trace"));
  EXPECT_THAT(refusal(table("time_s,torque\n", "{t},{x}\n")), HasSubstr("it has time_s, torque; say which"));
  EXPECT_THAT(refusal("time_s,x_mm\n0,1\n0.001,2\n"), HasSubstr("too few samples whose times rise: 2"));
  EXPECT_THAT(refusal(table("time_s,x_mm\n", "{t},{x}\n"), parse_trace_columns("x=X_mn")),
              HasSubstr("did you mean 'x_mm'?"));
  EXPECT_THAT(refusal("\xFF\xFE"
                      "a"),
              HasSubstr("UTF-16"));
  EXPECT_THAT(refusal("1 2\n" + std::string(3U << 20U, '7')),
              HasSubstr("t.csv:2: the line is longer than 1 MiB"));
}

constexpr const char* scope_head =
    "Name\tScope\nFile\tc:\\a.csv\nStarttime of export\t132959733843760000\nEndtime of "
    "export\t132959733853750000\n\n"
    "Name\tPos X\tName\tPos "
    "Y\tCurrent\nSymbolComment\t\tSymbolComment\t\t\nData-Type\tREAL64\tData-Type\tREAL64\tREAL64\n"
    "SampleTime[ms]\t1\tSampleTime[ms]\t2\t2\nSymbolName\tMAIN.a\tSymbolName\tMAIN.b\tMAIN.c\n\n";

TEST(ReadTrace, ReadsChannelsOfTwinCatScopeAtTheirOwnRates) {
  std::string text = scope_head;
  for (int i = 0; i < 21; ++i) {
    text += i <= 10 ? fmt::format("{}\t{},5\t{}\t{},25\t9\n", i, i, 2 * i, 2 * i)
                    : fmt::format("{}\t{},5\t\t\t\n", i, i);
  }
  const Trace trace = parse_trace(text + "EOF\n", "t.csv");
  EXPECT_EQ(trace.format, "TwinCAT Scope");
  ASSERT_EQ(trace.size(), 21U);
  EXPECT_NEAR(trace.period, 1e-3, 1e-12);
  EXPECT_NEAR(trace.place[0][7], 7.5, 1e-9);
  EXPECT_NEAR(trace.place[1][7], 7.25, 1e-9);  // between 6.25 and 8.25
  EXPECT_THAT(trace.notes, IsEmpty());
  EXPECT_THAT(refusal(scope_head), HasSubstr("no samples follow the head"));
}

std::string sinumerik(const std::string& records,
                      const std::string& end = "</dataFrame></traceData></traceSession>") {
  return "<?xml version=\"1.0\"?>\n<traceSession><traceDisplaySetup><signals>\n"
         "<signal key=\"a\" name=\"/Nck/x[1]\" description=\"Position setpoint X1\"/>\n"
         "<signal key=\"b\" name=\"/Nck/y[2]\" description=\"Position setpoint Y1\"/>\n"
         "<signal key=\"c\" name=\"/Nck/z[2]\" description=\"Torque Y1\"/>\n"
         "</signals></traceDisplaySetup><traceData><dataFrame>\n"
         "<dataSignal id=\"f1\" key=\"c\"/><dataSignal id=\"f2\" key=\"a\"/><dataSignal id=\"f3\" "
         "key=\"b\"/>\n" +
         records + end;
}

std::string sinumerik_records() {
  std::string records;
  for (int i = 0; i < 20; ++i) {
    records += fmt::format("<rec time=\"{}\" f1=\"1\" f2=\"{}\"{}/>\n", 0.004 * i, 3 * i,
                           i % 2 == 0 ? fmt::format(" f3=\"{}\"", -i) : "");
  }
  return records;
}

/// Records with what changes alone: Y stands after its first value, X before it moves.
TEST(ReadTrace, TakesWhatIsMissingForLongForUnchanged) {
  std::string records = "<rec time=\"0\" f2=\"1\" f3=\"5\"/>\n";
  for (int i = 1; i < 100; ++i) {
    const std::string x = i < 40 ? "" : fmt::format(" f2=\"{:.3f}\"", 0.1 * (i - 29));
    records += fmt::format("<rec time=\"{}\"{}/>\n", 0.004 * i, x);
  }
  const Trace trace = parse_trace(sinumerik(records), "t.xml");
  ASSERT_EQ(trace.size(), 100U);
  EXPECT_EQ(trace.place[0][39], 1);
  EXPECT_NEAR(trace.place[0][40], 1.1, 1e-12);
  EXPECT_EQ(trace.place[1][99], 5);
  EXPECT_THAT(codes(trace), HasSubstr("trace-unchanged"));
}

TEST(ReadTrace, ReadsSinumerikXmlByItsKeysAndInterpolatesMissingFields) {
  const Trace trace = parse_trace(sinumerik(sinumerik_records()), "t.xml");
  EXPECT_EQ(trace.format, "SINUMERIK trace");
  ASSERT_EQ(trace.size(), 19U);  // the last Y is missing
  EXPECT_NEAR(trace.period, 4e-3, 1e-12);
  EXPECT_NEAR(trace.place[0][5], 15, 1e-9);
  EXPECT_NEAR(trace.place[1][5], -5, 1e-9);
  EXPECT_THAT(trace.notes, Contains(Field(&Diagnostic::code, "trace-interpolated")));
}

TEST(ReadTrace, UsesWhatComesBeforeTheEndOfBrokenXml) {
  const Trace trace = parse_trace(sinumerik(sinumerik_records(), ""), "t.xml");
  EXPECT_EQ(trace.size(), 19U);
  EXPECT_THAT(codes(trace), HasSubstr("trace-xml"));
  const std::string broken = sinumerik(sinumerik_records() + "<rec ti1\"/>\n", "");
  const Trace read = parse_trace(broken, "t.xml");
  EXPECT_EQ(std::ranges::count(read.notes, "trace-xml", &Diagnostic::code), 1) << "told once, at its line";
  for (const Diagnostic& note : read.notes) {
    EXPECT_LE(note.line, std::ranges::count(broken, '\n'));
  }
  EXPECT_THAT(refusal("<a>"), HasSubstr("this is no whole XML file"));
  EXPECT_THAT(refusal("<a></a>"), HasSubstr("no record of a SINUMERIK trace"));
}

TEST(ReadTrace, ANumberThatNoAxisReachesIsAMissingValue) {
  std::string text = "time [ms];x [inch];y [mm]\n";
  for (int i = 0; i < 20; ++i) {
    text += std::to_string(i) + ';' + (i == 7 ? "1e308" : i == 9 ? "-1e308" : std::to_string(i)) + ";0\n";
  }
  const Trace trace = parse_trace(text, "t.csv");
  ASSERT_EQ(trace.size(), 20U);
  EXPECT_NEAR(trace.place[0][7], 7 * 25.4, 1e-9);
  EXPECT_NEAR(trace.place[0][9], 9 * 25.4, 1e-9);
  EXPECT_THAT(trace.notes, Contains(Field(&Diagnostic::code, "trace-interpolated")));
}

}  // namespace
}  // namespace feedscope
