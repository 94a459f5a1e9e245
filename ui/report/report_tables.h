#pragma once

#include <QString>
#include <utility>
#include <vector>

#include "core/analysis/program_facts.h"
#include "ui/report/report_input.h"

namespace feedscope::ui {

// Blocks of a report as HTML. Numbers have a decimal point and the units of people; all texts are escaped.

/// Runs side by side in a table; further ones follow in another.
inline constexpr std::size_t runs_a_table = 4;

/// What the program holds: dialect, blocks, path, extents, feeds, tools, path control by lines.
QString program_facts_block(const ReportInput& input);
/// Messages of the reader; empty if there are none.
QString messages_block(const ReportInput& input);
/// Limits and settings of each machine with the source of every number; assumed ones in italics.
QString machines_block(const ReportInput& input);
/// What is not the same in all runs; empty for one run.
QString differing_settings_block(const ReportInput& input);
/// Every setting that the models read, for each run.
QString settings_block(const ReportInput& input);
/// The models: title, reference, what they do and what they promise with the settings of the runs.
QString models_block(const ReportInput& input);

/// Which run is the fastest, or what a single one takes; HTML.
QString times_sentence(const ReportInput& input);
/// A paragraph for each different set of events that cycle times do not contain; may be empty.
QString not_counted_sentences(const ReportInput& input);
/// What run_notes() and undetermined_limits() say of the runs, each once, with the runs that it is said of
/// where those are not all; small paragraphs.
QString run_notes_text(const ReportInput& input);
/// One or two sentences with the main figures.
QString summary_block(const ReportInput& input);
/// Cycle time, feeds and contour error of each run.
QString comparison_block(const ReportInput& input);
/// Largest velocity, acceleration and jerk of each axis against its limits; where rotary axes turn, of them
/// too, and of X, Y and Z of the machine beside those of the tip.
QString peaks_block(const ReportInput& input);
/// Time by limiting cause.
QString causes_block(const ReportInput& input);

/// How long each kind of limit rules a run [s], the longest first; those that never do are omitted.
std::vector<std::pair<CauseKind, double>> time_by_kind(const Summary& summary);

/// "3000 mm/min", "500 to 3000 mm/min", "none".
QString programmed_feeds_text(const ProgramFacts& facts);

/// Letter, a square of its colour and what tells the run apart; of a single run the square and its name.
QString run_label(const ReportInput& input, std::size_t run);

}  // namespace feedscope::ui
