#pragma once

#include <QString>
#include <vector>

#include "core/analysis/agreement/trace_alignment.h"
#include "core/base/diagnostic.h"

namespace feedscope::ui {

/// What is wrong with a trace, and what of it on its program, the gravest first.
std::vector<Diagnostic> messages_on(const Trace& trace, const TraceOnProgram& found);
/// What a reader of traces says, with `instead` where it names the option --columns of the command line.
QString without_columns_option(QString text, const QString& instead);
/// What is wrong and what to do, as sentences in the user's language.
QString message_text(const Diagnostic& message);

}  // namespace feedscope::ui
