#pragma once

#include <span>
#include <string>

#include "core/analysis/contour/contour_report.h"

namespace feedscope {

/// Worst places of feed motions as CSV, largest error first: rank,line,block,time_s,path_mm,error_mm,side_mm,
/// tolerance_mm,at,length_mm,turn_deg,radius_mm,inside,x_mm,y_mm,z_mm,programmed_x_mm,programmed_y_mm,
/// programmed_z_mm,feed_mm_min,programmed_feed_mm_min,cause. `side_mm`: as in ContourErrors; `at`: line, arc
/// or corner; `inside`: 1 on the inner side of arc or corner, 0 on the outer one. Missing values are empty.
std::string contour_places_csv(const ContourReport& report);

/// Histogram of one of several runs.
struct NamedHistogram {
  std::string run;
  ContourHistogram histogram;
};

/// Histograms with the same edges as CSV: from_mm,to_mm and for each run its path length in the bin [mm]
/// under the run's name.
std::string contour_histogram_csv(std::span<const NamedHistogram> histograms);

}  // namespace feedscope
