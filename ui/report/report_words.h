#pragma once

#include <QCoreApplication>

namespace feedscope::ui {

/// Texts of reports and sheets in the user's language: ReportWords::tr("...").
struct ReportWords {
  Q_DECLARE_TR_FUNCTIONS(ReportWords)
};

}  // namespace feedscope::ui
