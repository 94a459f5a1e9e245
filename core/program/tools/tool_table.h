#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/program/text/source_text.h"
#include "core/program/tools/cutter_radii.h"

namespace feedscope {

/// Reads the cutter radii of a control's tool table. It recognises the format:
///  - LinuxCNC: "T1 P1 D10.0 Z50 ;end mill", D being the diameter;
///  - Sinumerik: "$TC_DP6[1,1]=5", "$TC_DP15[1,1]=-0.02" (wear, added), "$TC_TP2[1]=\"MILL_10\"" (its name);
///  - Fanuc and similar: "G10 L12 P1 R5.", L13 (wear, added), offset by offset;
///  - Heidenhain's TOOL.T and lists with a line of headings: T (or NR, TOOL), NAME, R (RADIUS), DR (added) or
///    D (DIAMETER), in columns of fixed width or with semicolons, commas or tabs between them.
/// `unit`: millimetres of a length, where the table does not give it (TOOL.T: MM or INCH; G20, G21).
/// A tool with a radius below zero is omitted, so that one odd row does not discard the others.
/// Throws InputError naming the file, and the line of a value that is not a number.
CutterRadii read_tool_table(const SourceText& text, double unit = 1);

/// File names of a table in a program's folder, in the order of preference.
const std::vector<std::string>& tool_table_names();

}  // namespace feedscope
