#include "tests/contract/hand_cases.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"

namespace feedscope::contract {
namespace {

using Lines = std::vector<std::string>;

Lines corner(double degrees, double length, double feed) {
  const double a = units::from_deg(degrees);
  return {fmt::format("G1 X{:.9f} F{}", length, feed),
          fmt::format("X{:.9f} Y{:.9f}", length + length * std::cos(a), length * std::sin(a))};
}

Lines repeated(const std::string& first, const std::string& line, int count) {
  Lines lines{first};
  lines.insert(lines.end(), static_cast<std::size_t>(count), line);
  return lines;
}

void add_corners(std::vector<HandCase>& cases) {
  for (const double degrees :
       {0.0,   1e-5,  1e-3,  0.1,   1.0,   10.0,  28.0,  29.0,     45.0,      89.0, 90.0,
        114.0, 116.0, 135.0, 150.0, 170.0, 179.0, 179.9, 179.9999, 179.99999, 180.0}) {
    cases.push_back({fmt::format("CornerOf{}Degrees", degrees), corner(degrees, 20, 3000)});
    cases.push_back({fmt::format("ShortCornerOf{}Degrees", degrees), corner(degrees, 0.01, 60000)});
  }
}

void add_sizes(std::vector<HandCase>& cases) {
  for (const char* feed : {"1", "1000", "60000"}) {
    cases.push_back(
        {fmt::format("BlocksOfAMillionthAtF{}", feed),
         {fmt::format("G1 X0.000002 F{}", feed), "X0.000004", "X0.000004 Y0.000002", "X0.000002"}});
  }
  for (const char* feed : {"100", "60000"}) {
    cases.push_back({fmt::format("BlocksOfAMetreAtF{}", feed),
                     {fmt::format("G1 X1000 F{}", feed), "Y1000", "X0", "Y0 Z500"}});
  }
  cases.push_back({"LongShortLong", {"G1 X500 F20000", "X500.001 Y0.001", "Y400", "Y400.000002", "X0"}});
  cases.push_back(
      {"FeedStairs", {"G1 X1 F1", "X2 F60000", "X3 F10", "X30 F30000", "X30.1 F5", "X60 F60000"}});
}

void add_arcs(std::vector<HandCase>& cases) {
  const auto add = [&](const char* name, Lines lines) { cases.push_back({name, std::move(lines)}); };
  add("FullCircle", {"G3 I10 F5000"});
  add("SmallFullCircle", {"G3 I0.01 F60000"});
  add("FullCircleOfAMetre", {"G2 J500 F60000"});
  add("ThreeTurns", {"G3 I10 P3 F5000"});
  add("Helix", {"G3 I10 Z5 P2 F5000"});
  add("SteepHelix", {"G18 G2 Y100 K1 F5000"});
  add("CirclesInEveryPlane", {"G17 G3 I5 F4000", "G18 G3 K5", "G19 G3 J5"});
  add("LineIntoArcTangent", {"G1 X20 F4000", "G3 X30 Y10 J10", "G1 Y30"});
  add("LineIntoArcAtAnAngle", {"G1 X20 F4000", "G3 X30 Y10 I10", "G1 X50"});
  add("ArcIntoArcInflection", {"G3 X10 Y10 J10 F4000", "G2 X20 Y20 I10", "G3 X30 Y30 J10"});
  add("ArcIntoTighterArc", {"G3 X20 Y20 J20 F4000", "G3 X15 Y25 I-5", "G3 X5 Y15 J-10"});
  add("ArcReversal", {"G3 X10 Y10 J10 F4000", "G2 X0 Y0 I-10"});
  add("ArcThenBackOnALine", {"G3 X0 Y20 J10 F4000", "G1 X10"});
}

void add_stops(std::vector<HandCase>& cases) {
  const auto add = [&](const char* name, Lines lines) { cases.push_back({name, std::move(lines)}); };
  add("Dwell", {"G1 X10 F3000", "G4 P0.5", "X20"});
  add("DwellsOnly", {"G4 P0.5", "G4 P1.25"});
  add("DwellInACorner", {"G1 X10 F3000", "G4 P0.001", "Y10"});
  add("RapidsAndFeeds", {"G0 X10", "G0 Y10", "G1 X20 F3000", "G0 X50 Y20 Z5", "G1 Y50"});
  add("RapidsInALine", {"G0 X10", "G0 X20", "G1 X30 F3000", "G0 X40"});
  add("ThereAndBack", {"G1 X10 F3000", "X0", "X10", "X0"});
  add("ShortThereAndBack", repeated("G1 X0.001 F60000", "G91 X-0.0005", 5));
}

/// Programs of a Sinumerik whose acceleration may jump, on all or on some of its blocks.
void add_brisk(std::vector<HandCase>& cases) {
  Lines curve{"BRISK G642", "G1 F10000"};
  for (int i = 1; i <= 60; ++i) {
    curve.push_back(fmt::format("X{:.5f} Y{:.5f}", 20 * std::sin(i * 0.05), 20 - 20 * std::cos(i * 0.05)));
  }
  cases.push_back({"BriskLine", {"BRISK", "G1 X10 F3000"}});
  cases.push_back({"BriskCurve", curve});
  cases.push_back({"BriskArcs", {"BRISK", "G1 X20 F4000", "G3 X30 Y10 J10", "G1 Y30", "G2 X40 Y40 I10"}});
  cases.push_back({"BriskAndSoft",
                   {"BRISK G642", "G1 X20 F6000", "Y20", "SOFT", "X0", "Y0.5", "BRISK", "X0.1 Y0.2", "X30"}});
  cases.push_back({"Drive", {"DRIVE G642", "G1 X20 F6000", "Y20"}});
}

void add_runs(std::vector<HandCase>& cases) {
  Lines collinear{"G1 F3000"};
  Lines curve{"G1 F10000"};
  Lines zigzag{"G1 F10000"};
  for (int i = 1; i <= 60; ++i) {
    collinear.push_back(fmt::format("X{:.3f} Y{:.3f}", i * 0.3, i * 0.4));
    curve.push_back(fmt::format("X{:.5f} Y{:.5f}", 20 * std::sin(i * 0.01), 20 - 20 * std::cos(i * 0.01)));
    zigzag.push_back(fmt::format("X{:.3f} Y{:.3f}", i * 0.2, i % 2 == 0 ? 0.0 : 0.2));
  }
  cases.push_back({"CollinearRun", collinear});
  cases.push_back({"DenseCurve", curve});
  cases.push_back({"ZigZag", zigzag});
  cases.push_back({"RepeatedPoint", repeated("G1 X10 F3000", "X10", 1000)});
  cases.push_back({"OneBlock", {"G1 X10 F3000"}});
  cases.push_back({"Nothing", {}});
  cases.push_back({"CommentsOnly", {"(nothing)", "; at all"}});
  cases.push_back({"NoFeed", {"G1 X10", "Y10"}});
}

}  // namespace

std::vector<HandCase> hand_cases() {
  std::vector<HandCase> cases;
  add_runs(cases);
  add_corners(cases);
  add_sizes(cases);
  add_arcs(cases);
  add_stops(cases);
  add_brisk(cases);
  return cases;
}

}  // namespace feedscope::contract
