#pragma once

#include <QString>
#include <cstdint>
#include <string>
#include <vector>

#include "ui/report/paged_pdf.h"
#include "ui/report/report_input.h"
#include "ui/report/report_pictures.h"
#include "ui/report/report_template.h"

namespace feedscope::ui {

/// `pages`: RecordedPages, printed by the window.
enum class ReportFormat : std::uint8_t { pdf, html, pages };

/// All placeholders of templates; resources/report/README.md describes their contents.
QStringList report_placeholders();

/// The shipped template for "", else the one in `file` with its pictures embedded. Throws InputError as
/// read_template, with_pictures_inside and ReportTemplate.
ReportTemplate load_report_template(const QString& file = {});

/// A report before it is laid out.
struct ReportPage {
  QString html;  ///< refers to its pictures by name
  ReportPictures pictures;
};
/// Throws Cancelled if `progress` is cancelled.
ReportPage report_page(const ReportInput& input, const ReportTemplate& page, ReportFormat format,
                       Progress* progress = nullptr);

/// The bytes of its file; `texts` are not used in HTML.
std::string file_of(const ReportPage& page, ReportFormat format, const PageTexts& texts);

/// The bytes of the report; needs a QApplication. The same input and template give the same bytes. Throws
/// Cancelled if `progress` is cancelled.
std::string make_report(const ReportInput& input, const ReportTemplate& page, ReportFormat format,
                        Progress* progress = nullptr);
/// The pages of the PDF file as pictures: one PNG file each, with `dpi` pixels per inch. Otherwise as
/// make_report().
std::vector<std::string> make_report_pictures(const ReportInput& input, const ReportTemplate& page,
                                              double dpi, Progress* progress = nullptr);

}  // namespace feedscope::ui
