#include "ui/language/operation_title.h"

#include <QCoreApplication>

namespace feedscope::ui {

namespace {

struct OperationTitles {
  Q_DECLARE_TR_FUNCTIONS(OperationTitles)
};

}  // namespace

QString operation_title(const std::string& title, std::uint32_t line, OperationSplit split) {
  const QString text = QString::fromStdString(title);
  const bool first = title == before_first_tool;
  if (split == OperationSplit::tool) {
    return first ? OperationTitles::tr("Before the first tool")
                 : OperationTitles::tr("Tool %1").arg(text.section(QLatin1Char(' '), 1));
  }
  return first                          ? OperationTitles::tr("Before the first comment")
         : title == title_of_line(line) ? OperationTitles::tr("Line %1").arg(line)
                                        : text;
}

}  // namespace feedscope::ui
