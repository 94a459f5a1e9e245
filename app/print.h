#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/analysis/run/source_figures.h"

namespace feedscope {

/// Rows of text in aligned columns.
class TextTable {
 public:
  void add(std::vector<std::string> row) { rows_.push_back({std::move(row), false}); }
  /// Adds a line above the rows that follow, independent of the columns.
  void add_heading(std::string text) { rows_.push_back({{std::move(text)}, true}); }
  /// `alignments`: 'l' or 'r' for every column.
  std::string text(std::string_view alignments) const;

 private:
  struct Row {
    std::vector<std::string> cells;
    bool heading;
  };
  std::vector<Row> rows_;
};

/// `text` with line breaks between words, for a terminal of 100 columns if its words allow; lines after the
/// first begin with `indent` blanks, and the first is printed after as many.
std::string wrapped(const std::string& text, std::size_t indent);

/// "1.249 s"; from a minute on also in hours: "3725.4 s (1:02:05)".
std::string time_text(double seconds);

/// A difference with its sign, or without where it is rounded to 0: "+1.50", "-0.25", "0.00".
std::string signed_text(double value, int decimals);

/// Suffix of a mean feed: ", without pauses of 4.000 s"; empty without pauses.
std::string without_pauses_text(double pauses);

/// Replaces the cycle time of a program that the control refuses.
inline constexpr const char* refused_word = "refused";
inline constexpr const char* out_of_reach_word = "out of reach";
/// " The control refuses 4 lines of the program; they are not run."; empty for none.
std::string not_run_text(std::size_t lines);

/// Texts of a figure in tables of runs: "actual error", "[mm]", "0.0125"; "-" where a run has none.
std::string figure_title(const SourceFigure& figure);
std::string figure_unit(const SourceFigure& figure);
std::string figure_text(const SourceFigure& figure, const Summary& summary);

/// Layout of diagnostics on standard error, like a compiler's.
enum class DiagnosticStyle {
  line,         ///< one line each
  with_source,  ///< also the line of the program, with a mark under the place
};
void print_diagnostics(const Program& program, DiagnosticStyle style = DiagnosticStyle::line);
/// Prints diagnostics on `program` to standard error.
void print_diagnostics(const std::vector<Diagnostic>& diagnostics, const Program& program,
                       DiagnosticStyle style = DiagnosticStyle::line);

/// Prints diagnostics on a file other than a program.
void print_diagnostics(const std::vector<Diagnostic>& diagnostics, std::string_view file);

/// Figures of a run for people.
std::string summary_text(const Run& run);

}  // namespace feedscope
