#pragma once

#include <span>
#include <string>

#include "core/analysis/circularity/circular_test.h"

namespace feedscope {

/// Circular tests of one setup as JSON, keys of README.md beside this file: an entry for each direction of
/// every test.
std::string circular_json(const Setup& setup, std::span<const CircularTest> tests);

/// The same as CSV, one row for each direction: radius_mm,feed_mm_min,plane,direction,reached_feed_mm_min,
/// time_s,G_um,G_ls_um,Gb_um,Fmax_um,Fmin_um,D_um.
std::string circular_csv(std::span<const CircularTest> tests);

}  // namespace feedscope
