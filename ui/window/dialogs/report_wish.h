#pragma once

#include <QDate>
#include <QString>
#include <QStringList>
#include <vector>

#include "ui/report/report_input.h"
#include "ui/session/session.h"

namespace feedscope::ui {

/// A part of reports that can be omitted, or added.
struct ReportPart {
  QString title;             ///< for people
  QStringList placeholders;  ///< of the template, empty without this part; none for a section
  QString section = {};      ///< of the template, included on request
  bool usual = true;         ///< whether it is included by default

  const QString& key() const { return section.isEmpty() ? placeholders.front() : section; }
};
/// In the order of the shipped template.
std::vector<ReportPart> report_parts();

/// Options of a report.
struct ReportWish {
  QString title;   ///< empty: the program's name
  QString author;  ///< may be empty
  QDate date;      ///< invalid: none
  QString remarks;
  QString logo;                           ///< picture file; may be empty
  QString page;                           ///< template file; empty: the shipped one
  QString language;                       ///< code; empty: English
  QString paper;                          ///< as of --paper; empty: A4
  QStringList without;                    ///< placeholders
  QStringList with = ReportInput().with;  ///< sections
  std::vector<bool> runs;  ///< for each run of the session, whether it is included; at least one is
};

/// Arguments of `feedscope report` that make it from a session file, without --out.
QStringList report_arguments(const ReportWish& wish, const QString& session);

/// The session with the chosen runs only. Pictures show the current run, or else the first chosen one.
Session with_runs(Session session, const std::vector<bool>& wanted);

}  // namespace feedscope::ui
