#pragma once

#include <string>
#include <vector>

namespace feedscope::samples {

/// An NC program of resources/programs/, made from its geometry.
struct Sample {
  std::string file_name;
  std::string text;  ///< the same bytes on every machine: LF line ends, decimal point
};

/// Polyline of Essid 2019, table 1.
Sample essid_table1();
/// Cubic of Essid 2019, cut greedily into chords that deviate by 0.5 mm.
Sample essid_spline();
/// Bores of 80 and 25 mm with quarter-circle approach and exit, after Tapie 2007, section 6.
std::vector<Sample> tapie_bores();
/// Full circles of 2.5 and 30 mm of Tapie 2007, table 2.
std::vector<Sample> tapie_circles();
/// Spirals of half and of quarter circles of Tapie 2007, section 5; the latter in three directions.
std::vector<Sample> tapie_spirals();
/// Pocket cleared by concentric passes of lines and arcs, in the manner of Msaddek 2011, section 3.2.
Sample msaddek_pocket();
/// Trochoidal slot whose cutting arcs are short blocks, in the manner of Ward 2021, section 4.1.
Sample trochoidal_slot();
/// Zigzag finishing of a free-form surface in more than 50 000 short blocks.
Sample freeform_finish();
/// Twisted blade with tool vectors, finished by one spiral: the direction turns by 180 degrees at its edges.
Sample blade();

/// The small programs of resources/lessons, one effect each.
std::vector<Sample> lesson_programs();

/// Every shipped program.
std::vector<Sample> all_samples();

}  // namespace feedscope::samples
