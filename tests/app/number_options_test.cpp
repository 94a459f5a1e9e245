#include <gmock/gmock.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/app/command_line.h"
#include "tests/support/random_cases.h"

namespace feedscope::test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;

struct Option {
  std::string command;
  std::string name;
  std::string type;  ///< as --help names its value
};

/// Values of the kinds of options that hold numbers: one that could be a thousand, and the same number with
/// either decimal sign ("" where a comma is never taken).
struct Numeric {
  std::string ambiguous;
  std::string comma;
  std::string point;
};

const std::map<std::string, Numeric> numeric_types{
    {"MM", {"1,000", "0,5", "0.5"}},
    {"MM_MIN", {"1,000", "50,5", "50.5"}},
    {"DEG", {"1,000", "50,5", "50.5"}},
    {"S", {"1,000", "0,5", "0.5"}},
    {"N", {"1,000", "50,5", "50.5"}},
    {"X", {"1,000", "0,5", "0.5"}},
    {"TOOL=MM", {"1=1,000", "1=0,5", "1=0.5"}},
    {"KEY=VALUE", {"X.jerk=1,000", "X.jerk=20,5", "X.jerk=20.5"}},
    {"KEY=RANGE", {"X.jerk=1,000", "", ""}},
    {"OFFSET=X,Y,Z", {"G55=1,000;0;0", "G55=0,5;0;0", "G55=0.5;0;0"}},
    {"WxH", {"1,000x900", "", ""}},
    {"WxH|PAPER", {"1,000x900", "", ""}}};
/// "Excludes" and "Needs" are what --help says behind a flag.
const std::set<std::string> other_types{"Excludes",
                                        "Needs",
                                        "",
                                        "DIR",
                                        "LINE|TIME",
                                        "PAPER",
                                        "FILE",
                                        "FILE.png",
                                        "FILE.toml",
                                        "FILE.feedscope",
                                        "FILE.pdf|FILE.html",
                                        "FILE.ogv|FILE%05d.png",
                                        "ID",
                                        "LANGUAGE",
                                        "READER",
                                        "PLANE",
                                        "ID|FILE",
                                        "SPEC|PRESET|FILE",
                                        "KEY,...",
                                        "UNIT",
                                        "UNITS",
                                        "JSON",
                                        "TEXT",
                                        "VIEW",
                                        "CAMERA",
                                        "COLOUR",
                                        "THEME",
                                        "FORMAT",
                                        "tool|comment",
                                        "FILE.png|svg|pdf",
                                        "FILE.pdf|FILE.html",
                                        "FILE.pdf|FILE.html|FILE.png",
                                        "NAME,...",
                                        "FILE.html",
                                        "SHELL",
                                        "YYYY-MM-DD"};

/// Every option with a number of every command, as the commands' own help lists them, so that none is
/// forgotten.
class NumberOptions : public CommandLine {
 protected:
  NumberOptions() {
    std::string samples = "time_s,x_mm,y_mm\n";
    for (int i = 0; i < 100; ++i) {
      samples += std::to_string(0.01 * i) + "," + std::to_string(0.2 * i) + ",0\n";
    }
    write("samples.csv", samples);
  }

  std::vector<std::string> commands() const {
    std::vector<std::string> names;
    std::istringstream lines(run("--help").out);
    bool listed = false;
    for (std::string line; std::getline(lines, line);) {
      listed = listed || line == "Subcommands:";
      std::smatch name;
      if (listed && std::regex_search(line, name, std::regex("^  ([a-z]+)"))) {
        names.push_back(name[1]);
      }
    }
    return names;
  }

  std::vector<Option> options() const {
    std::vector<Option> all;
    for (const std::string& command : commands()) {
      std::istringstream lines(run(command + " --help").out);
      for (std::string line; std::getline(lines, line);) {
        std::smatch parts;
        if (std::regex_search(line, parts, std::regex("^ +(?:-[a-zA-Z],)?(--[a-z-]+)(?: ([^ :]+))?"))) {
          all.push_back({command, parts[1], parts[2]});
        }
      }
    }
    return all;
  }

  std::vector<Option> with_numbers() const {
    std::vector<Option> numbers;
    for (const Option& option : options()) {
      if (numeric_types.contains(option.type)) {
        numbers.push_back(option);
      } else {
        EXPECT_TRUE(other_types.contains(option.type))
            << option.command << " " << option.name << " takes '" << option.type
            << "': add it to numeric_types or other_types";
      }
    }
    return numbers;
  }

  /// What the command needs beside the option, so that it would run.
  static std::string call(const Option& option, const std::string& program, const std::string& value) {
    std::string line = option.command + " " + program + " " + option.name + " '" + value + "'";
    const std::set<std::string> of_program{"--tool", "--offset", "--circle", "--repeat-limit",
                                           "--call-depth"};
    if (option.command == "circular" && of_program.contains(option.name)) {
      line += " --out a.png";
    } else if (option.command == "circular") {
      line = "circular " + option.name + " '" + value + "'";
      line += option.name == "--radius" ? "" : " --radius 5";
      line += option.name == "--feed" ? "" : " --feed 500";
      line += option.name == "--size" ? " --out a.png" : "";
    }
    if (option.command == "trace") {
      line = "trace samples.csv " + program + " " + option.name + " '" + value + "'";
    }
    if (option.command == "identify") {
      line = "identify samples.csv --model linuxcnc --fit X.velocity --program " + program + " " +
             option.name + " '" + value + "'";
    }
    if (option.command == "render" || option.command == "report") {
      line += option.command == "render" ? " --out a.png" : " --out a.html";
    }
    line += option.name == "--contour-places" ? " --contour -" : "";
    line += option.command == "compare" && option.name == "--size" ? " --png a.png" : "";
    return line;
  }
};

TEST_F(NumberOptions, RefuseACommaThatCouldGroupThousands) {
  const std::vector<Option> numbers = with_numbers();
  EXPECT_GT(numbers.size(), 15u);
  for (const Option& option : numbers) {
    const Result result = run(call(option, "corner.nc", numeric_types.at(option.type).ambiguous));
    EXPECT_EQ(result.code, 2) << option.command << option.name;
    EXPECT_EQ(result.out, "") << option.command << option.name;
    EXPECT_THAT(result.err,
                AllOf(HasSubstr("1,000"), AnyOf(HasSubstr("write 1.000"), HasSubstr("give width"))))
        << option.command << " " << option.name;
  }
}

TEST_F(NumberOptions, TakeEitherDecimalSignForTheSameNumber) {
  for (const Option& option : test::in_turns(with_numbers())) {
    const Numeric& values = numeric_types.at(option.type);
    if (values.comma.empty()) {
      continue;
    }
    const bool draws = option.command == "render" || option.command == "report";
    const std::string program = draws ? "none.nc" : "corner.nc";
    const Result comma = run(call(option, program, values.comma));
    const Result point = run(call(option, program, values.point));
    EXPECT_EQ(comma.code, point.code) << option.command << option.name;
    EXPECT_EQ(comma.err, point.err) << option.command << option.name;
    std::string said = comma.out;  // headings and commands to run may repeat what was typed
    for (std::size_t at = said.find(values.comma); at != std::string::npos;
         at = said.find(values.comma, at + values.point.size())) {
      said.replace(at, values.comma.size(), values.point);
    }
    EXPECT_EQ(said, point.out) << option.command << option.name;
  }
}

TEST_F(NumberOptions, HaveTheirRuleInTheHelp) {
  std::set<std::string> with;
  for (const Option& option : with_numbers()) {
    with.insert(option.command);
  }
  for (const std::string& command : with) {
    EXPECT_THAT(run(command + " --help").out, HasSubstr("Numbers have a decimal point or comma")) << command;
  }
}

TEST_F(NumberOptions, ListsHaveNoComma) {
  for (const std::string values : {"0,05", "0.01,0.02", "0,005:0,1:log12", "0,01;0,02"}) {
    const Result result = run("compare corner.nc --sweep 'tolerance=" + values + "'");
    EXPECT_EQ(result.code, 2) << values;
    EXPECT_THAT(result.err, AllOf(HasSubstr("has a comma"), HasSubstr("in quotes"))) << values;
  }
  const std::string sweep = "compare corner.nc --model essid --csv - --sweep ";
  EXPECT_EQ(run(sweep + "'tolerance=0.01 0.02'").out, run(sweep + "'tolerance=0.01;0.02'").out);
  EXPECT_EQ(run(sweep + "'tolerance=0.01 0.02'").out, run(sweep + "tolerance=0.01:0.02:lin2").out);
}

}  // namespace
}  // namespace feedscope::test
