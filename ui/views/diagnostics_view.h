#pragma once

#include <QTreeWidget>
#include <cstdint>

#include "core/program/program.h"

namespace feedscope::ui {

/// What the reader found wrong or worth knowing in a program, and messages of the application.
class DiagnosticsView : public QTreeWidget {
  Q_OBJECT

 public:
  explicit DiagnosticsView(QWidget* parent = nullptr);

  /// Replaces all entries; at most the first 1 000 are listed, the last entry says how many more there are.
  void set_diagnostics(const std::vector<Diagnostic>& diagnostics);
  void add_message(Severity severity, const QString& message);

 signals:
  void line_chosen(std::uint32_t line);

 private:
  void add(const Diagnostic& diagnostic);
};

}  // namespace feedscope::ui
