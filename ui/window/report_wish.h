#pragma once

#include <QDate>
#include <QString>
#include <QStringList>
#include <vector>

#include "ui/report/report_input.h"
#include "ui/session/session.h"

namespace feedscope::ui {

/// A part of reports that may be omitted, or added.
struct ReportPart {
  QString title;             ///< for people
  QStringList placeholders;  ///< of the template, empty without it; none where it is a section
  QString section = {};      ///< of the template, which is asked for
  bool usual = true;         ///< it is there unless people say otherwise

  const QString& key() const { return section.isEmpty() ? placeholders.front() : section; }
};
/// In the order of the shipped template.
std::vector<ReportPart> report_parts();

/// What a report is to be like.
struct ReportWish {
  QString title;   ///< empty: the program's name
  QString author;  ///< may be empty
  QDate date;      ///< invalid: none is written
  QString remarks;
  QString logo;                           ///< picture file; may be empty
  QString page;                           ///< template file; empty: the shipped one
  QString language;                       ///< code; empty: English
  QString paper;                          ///< as of --paper; empty: A4
  QStringList without;                    ///< placeholders
  QStringList with = ReportInput().with;  ///< sections
  std::vector<bool> runs;                 ///< which runs of the session; at least one
};

/// Arguments of `feedscope report` that make it of a session file: all but --out.
QStringList report_arguments(const ReportWish& wish, const QString& session);

/// The session with these runs alone. The current run, or else the first of them, is the one that pictures
/// show.
Session with_runs(Session session, const std::vector<bool>& wanted);

}  // namespace feedscope::ui
