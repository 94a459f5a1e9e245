#pragma once

#include <QString>
#include <utility>
#include <vector>

#include "core/analysis/run/program_facts.h"
#include "ui/report/report_input.h"

namespace feedscope::ui {

// Blocks of a report as HTML. Numbers have a decimal point and display units; all texts are escaped.

/// Runs side by side in one table; further ones follow in another.
inline constexpr std::size_t runs_a_table = 4;

/// Facts on the program: dialect, blocks, path, extents, feeds, tools, path control by lines.
QString program_facts_block(const ReportInput& input);
/// Messages of the reader; empty if there are none.
QString messages_block(const ReportInput& input);
/// Limits and settings of each machine with the source of every number; assumed ones in italics.
QString machines_block(const ReportInput& input);
/// Settings that differ between the runs; empty for one run.
QString differing_settings_block(const ReportInput& input);
/// All settings of the models, for each run.
QString settings_block(const ReportInput& input);
/// The models: title, reference, description and guarantees with the settings of the runs.
QString models_block(const ReportInput& input);

/// The remarks on the runs, each once, with its runs if not all; small paragraphs.
QString remarks_html(const ReportInput& input);
/// Headline and verdict of the first page, main causes of the current run, remarks.
QString summary_block(const ReportInput& input);
/// Cycle time, feeds and contour error of each run.
QString comparison_block(const ReportInput& input);
/// Largest velocity, acceleration and jerk of each axis compared with its limits. Where rotary axes turn,
/// also theirs, and those of the machine's X, Y and Z next to those of the tip.
QString peaks_block(const ReportInput& input);
/// Time by limiting cause.
QString causes_block(const ReportInput& input);

/// Time during which each kind of limit is active in a run [s], the longest first, without zeros.
std::vector<std::pair<CauseKind, double>> time_by_kind(const Summary& summary);

/// "3000 mm/min", "500 to 3000 mm/min", "none".
QString programmed_feeds_text(const ProgramFacts& facts);

/// Letter, a square of its colour and what tells the run apart; of a single run the square and its name.
QString run_label(const ReportInput& input, std::size_t run);

}  // namespace feedscope::ui
