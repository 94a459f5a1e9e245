#pragma once

#include <QColor>
#include <QString>
#include <filesystem>
#include <string>

namespace feedscope::ui {

/// A recorded trace of the program: a run that was not simulated.
struct TraceItem {
  int id = 0;  ///< never reused for another trace; 0: none yet
  std::filesystem::path file;
  std::string columns;  ///< specification for parse_trace_columns(); empty: detected from the file
  QString name;
  QColor colour;
  bool visible = true;  ///< drawn with the current run

  bool operator==(const TraceItem&) const = default;
};

}  // namespace feedscope::ui
