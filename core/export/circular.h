#pragma once

#include <span>
#include <string>

#include "core/analysis/circularity/circular_test.h"
#include "core/analysis/circularity/program_circles.h"

namespace feedscope {

/// Circular tests of one setup as JSON, keys in README.md next to this file: an entry for each direction of
/// every test.
std::string circular_json(const Setup& setup, std::span<const CircularTest> tests);

/// As CSV, one row for each direction: radius_mm,feed_mm_min,plane,direction,reached_feed_mm_min,
/// time_s,G_um,G_ls_um,Gb_um,Fmax_um,Fmin_um,D_um.
std::string circular_csv(std::span<const CircularTest> tests);

/// Full circles of `program` likewise, with the additional data of program circles: an entry for each circle,
/// in the order of the tests.
std::string program_circles_json(const Setup& setup, const Program& program, const ProgramCircles& circles);

/// As CSV, with these columns after those of circular_csv():
/// Fmean_um,first_line,last_line,centre_x_mm,centre_y_mm, centre_z_mm,start_deg,sweep_deg,evaluated_deg,path;
/// Gb_um and D_um are empty for one direction.
std::string program_circles_csv(const ProgramCircles& circles);

}  // namespace feedscope
