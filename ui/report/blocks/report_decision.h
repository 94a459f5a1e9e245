#pragma once

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

// Blocks of the first page of a report: the run to take, what it gains and where it still loses time.

/// Title if it is not the program, program, machine and common settings of the runs, in one line.
QString subject_block(const ReportInput& input);
/// The decision in a sentence; for a single run its cycle time and loss.
QString headline_block(const ReportInput& input);
/// Reasons for the choice, then defects of program and runs: the first error, lines that are not run,
/// tolerances without effect.
QString verdict_block(const ReportInput& input);
/// Cycle time over contour error and the causes of each run.
QString decision_charts_block(const ReportInput& input, ReportPictures& pictures);
/// Letter, line, cycle time, contour error and mean feed of each run; for machines with drives the actual
/// contour error.
QString runs_table_block(const ReportInput& input, ReportPictures& pictures);
/// The path of the current run, in the rest of the page.
QString path_block(const ReportInput& input, ReportPictures& pictures);
/// A lens at the worst corner of the current run, its losses of time and helpful changes.
QString losses_block(const ReportInput& input, ReportPictures& pictures);

/// "B (0.02 mm)"; the name only for a single run.
QString lettered_name(const ReportInput& input, std::size_t run);

}  // namespace feedscope::ui
