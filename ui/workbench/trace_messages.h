#pragma once

#include <QString>
#include <vector>

#include "core/analysis/agreement/trace_alignment.h"
#include "core/base/diagnostic.h"

namespace feedscope::ui {

/// Errors of a trace, in itself and on its program, the most severe first.
std::vector<Diagnostic> messages_on(const Trace& trace, const TraceOnProgram& found);
/// A message of the trace readers, with `instead` in place of the command line's option --columns.
QString without_columns_option(QString text, const QString& instead);
/// Error and advice, as sentences in the user's language.
QString message_text(const Diagnostic& message);

}  // namespace feedscope::ui
