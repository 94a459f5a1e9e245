#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/run.h"
#include "core/analysis/source_figures.h"

namespace feedscope {

/// Rows of text in aligned columns.
class TextTable {
 public:
  void add(std::vector<std::string> row) { rows_.push_back({std::move(row), false}); }
  /// A line of its own above the rows that follow, whatever the columns are.
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

/// `text` with line breaks between words so that no line is wider than a terminal of 100 columns, if its
/// words allow; lines after the first begin with `indent` blanks, and so does the place where the first is
/// printed.
std::string wrapped(const std::string& text, std::size_t indent);

/// "1.249 s", from a minute on with hours: "3725.4 s (1:02:05)".
std::string time_text(double seconds);

/// A difference with its sign, and none where it is rounded to 0: "+1.50", "-0.25", "0.00".
std::string signed_text(double value, int decimals);

/// Behind a mean feed: ", without pauses of 4.000 s"; empty where there are none.
std::string without_pauses_text(double pauses);

/// Shown instead of the cycle time of a program that the control refuses.
inline constexpr const char* refused_word = "refused";
inline constexpr const char* out_of_reach_word = "out of reach";
/// " The control refuses 4 lines of the program; they are not run."; empty for none.
std::string not_run_text(std::size_t lines);

/// How tables of runs have a figure: "actual error", "[mm]", "0.0125"; "-" where a run has none.
std::string figure_title(const SourceFigure& figure);
std::string figure_unit(const SourceFigure& figure);
std::string figure_text(const SourceFigure& figure, const Summary& summary);

/// Diagnostics to standard error, one line each as a compiler does.
enum class DiagnosticStyle {
  line,         ///< one line each
  with_source,  ///< and the line of the program, with a mark under the place
};
void print_diagnostics(const Program& program, DiagnosticStyle style = DiagnosticStyle::line);
/// The same of other messages about the program.
void print_diagnostics(const std::vector<Diagnostic>& diagnostics, const Program& program,
                       DiagnosticStyle style = DiagnosticStyle::line);

/// The same of another file than a program.
void print_diagnostics(const std::vector<Diagnostic>& diagnostics, std::string_view file);

/// Figures of a run for people.
std::string summary_text(const Run& run);

}  // namespace feedscope
