#pragma once

#include <QDateTime>
#include <QString>
#include <string>
#include <vector>

#include "ui/paper/recorded_pages.h"
#include "ui/report/report_pictures.h"

namespace feedscope::ui {

/// Common texts of the pages of a document.
struct PageTexts {
  QString title;   ///< of the file, and on top of every page except the first
  QString author;  ///< of the file
  QDateTime date;  ///< invalid: none
  QString number = QStringLiteral("page %1 of %2");
  QString note = {};  ///< below every page, after the version
  Paper paper = {};
};

/// `html` laid out on pages with title, page numbers and bookmarks from its headings. Headings stay
/// with the text after them, and rows of tables on one page if they fit on one.
std::string paged_pdf(const QString& html, const ReportPictures& pictures, const PageTexts& texts);

/// The same pages for printing.
RecordedPages recorded_pages(const QString& html, const ReportPictures& pictures, const PageTexts& texts);

/// The same pages as pictures: one PNG file each, with `dpi` pixels per inch.
std::vector<std::string> paged_pictures(const QString& html, const ReportPictures& pictures,
                                        const PageTexts& texts, double dpi);

}  // namespace feedscope::ui
