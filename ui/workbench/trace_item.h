#pragma once

#include <QColor>
#include <QString>
#include <filesystem>
#include <string>

namespace feedscope::ui {

/// What a control recorded of the program: one more run, that was not simulated.
struct TraceItem {
  int id = 0;  ///< never used again for another trace; 0: none yet
  std::filesystem::path file;
  std::string columns;  ///< specification as parse_trace_columns() reads it; empty: found from the file
  QString name;
  QColor colour;
  bool visible = true;  ///< drawn beside the current run

  bool operator==(const TraceItem&) const = default;
};

}  // namespace feedscope::ui
