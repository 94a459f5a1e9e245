#include "ui/language/core_texts.h"

#include <QCoreApplication>

namespace feedscope::ui {

QString core_text(const std::string& text) {
  return QCoreApplication::translate("core", text.c_str());
}

QString shown_cause(Cause cause) {
  const CauseInfo& info = info_of(cause.kind);
  return info.by_axis() && cause.axis >= 0
             ? core_text(std::string(info.axis_title)).arg(QLatin1Char(axis_name(cause)))
             : core_text(std::string(info.title));
}

QString unit_text(const std::string& unit) {
  return QString::fromStdString(unit)
      .replace(QStringLiteral("s2"), QStringLiteral("s²"))
      .replace(QStringLiteral("s3"), QStringLiteral("s³"));
}

}  // namespace feedscope::ui
