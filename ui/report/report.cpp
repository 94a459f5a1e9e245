#include "ui/report/report.h"

#include <QRegularExpression>
#include <functional>
#include <utility>
#include <vector>

#include "ui/language/language.h"
#include "ui/paper/html_table.h"
#include "ui/report/blocks/report_cards.h"
#include "ui/report/blocks/report_circles.h"
#include "ui/report/blocks/report_contour.h"
#include "ui/report/blocks/report_decision.h"
#include "ui/report/blocks/report_identification.h"
#include "ui/report/blocks/report_load.h"
#include "ui/report/blocks/report_motion.h"
#include "ui/report/blocks/report_time.h"
#include "ui/report/blocks/report_traces.h"
#include "ui/report/blocks/report_trust.h"
#include "ui/report/page_fit.h"
#include "ui/report/paged_pdf.h"
#include "ui/report/report_html.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_tables.h"
#include "ui/report/report_words.h"
#include "ui/report/scene_picture.h"
#include "ui/report/template_pictures.h"

namespace feedscope::ui {

namespace {

/// Section for HTML files only, omitted on paper.
const QString screen_section = QStringLiteral("screen");

QString commands_block(const ReportInput& input) {
  QString html;
  for (const QString& command : input.commands) {
    html += QStringLiteral("<p class=\"command\">%1</p>\n").arg(command.toHtmlEscaped());
  }
  return html;
}

QString remarks_block(const ReportInput& input) {
  QString html;
  static const QRegularExpression empty_lines(QStringLiteral("\\n\\s*\\n"));
  for (const QString& paragraph : input.remarks.split(empty_lines, Qt::SkipEmptyParts)) {
    if (!paragraph.trimmed().isEmpty()) {
      html += QStringLiteral("<p>%1</p>\n")
                  .arg(html_text(paragraph.trimmed()).replace('\n', QStringLiteral("<br/>")));
    }
  }
  return html;
}

QString logo_block(const ReportInput& input) {
  if (input.logo.isEmpty()) {
    return {};
  }
  constexpr double height = 48;  // [1/96 inch]
  constexpr double largest_width = 240;
  const auto picture = InlinePicture::from_url(input.logo);
  const QSizeF size = picture->size().scaled(largest_width, height, Qt::KeepAspectRatio);
  return QStringLiteral("<img src=\"%1\" width=\"%2\" height=\"%3\" alt=\"Logo\"/>")
      .arg(input.logo, QString::number(size.width(), 'f', 0), QString::number(size.height(), 'f', 0));
}

struct Block {
  const char* name;
  std::function<QString(const ReportInput&, ReportPictures&)> make;
};

/// Block without pictures.
auto plain(QString (*block)(const ReportInput&)) {
  return [block](const ReportInput& input, ReportPictures&) { return block(input); };
}

/// Block that a report of a single run omits.
template <class Make>
auto for_several(Make make) {
  return [make](const ReportInput& input, ReportPictures& pictures) {
    return input.runs.size() > 1 ? make(input, pictures) : QString();
  };
}

const std::vector<Block>& blocks() {
  static const std::vector<Block> list{
      {"title", plain([](const ReportInput& input) { return input.heading().toHtmlEscaped(); })},
      {"author", plain([](const ReportInput& input) { return input.author.toHtmlEscaped(); })},
      {"date", plain([](const ReportInput& input) { return date_text(input.date); })},
      {"logo", plain(logo_block)},
      {"remarks", plain(remarks_block)},
      {"subject", plain(subject_block)},
      {"headline", plain(headline_block)},
      {"verdict", plain(verdict_block)},
      {"decision_charts", decision_charts_block},
      {"runs_table", runs_table_block},
      {"path", path_block},
      {"losses", losses_block},
      {"cards", cards_block},
      {"feed_course", feed_course_block},
      {"motion_windows", motion_windows_block},
      {"trust", plain(trust_block)},
      {"program", plain([](const ReportInput& input) {
         return program_file_name(*input.program().program).toHtmlEscaped();
       })},
      {"machine", plain([](const ReportInput& input) {
         return QString::fromStdString(input.run().shown->run.setup.machine.name).toHtmlEscaped();
       })},
      {"run", plain([](const ReportInput& input) { return input.run().name.toHtmlEscaped(); })},
      {"lettered_run", plain([](const ReportInput& input) { return lettered_name(input, input.current); })},
      {"language", plain([](const ReportInput&) { return spoken_language(); })},
      {"version", plain([](const ReportInput&) { return QStringLiteral(FEEDSCOPE_VERSION); })},
      {"summary", plain(summary_block)},
      {"comparison_table", plain(comparison_block)},
      {"time_use", plain(time_use_block)},
      {"time_places", plain(time_places_block)},
      {"time_changes", plain(time_changes_block)},
      {"comparison_bars", for_several(bars_block)},
      {"peaks_table", plain(peaks_block)},
      {"causes_table", plain(causes_block)},
      {"differing_settings", plain(differing_settings_block)},
      {"view", view_block},
      {"cause_view", cause_view_block},
      {"charts", charts_block},
      {"slow_places", plain(slow_places_block)},
      {"slow_place_views", slow_place_views_block},
      {"contour_histogram", contour_histogram_block},
      {"contour_places", plain(contour_places_block)},
      {"contour_place_views", contour_place_views_block},
      {"circles", plain(circles_block)},
      {"circle_plots", circle_plots_block},
      {"traces", plain(traces_block)},
      {"identification", plain(identification_block)},
      {"identification_charts", identification_charts_block},
      {"load", plain(load_block)},
      {"load_view", load_view_block},
      {"notes", plain(notes_block)},
      {"program_facts", plain(program_facts_block)},
      {"messages", plain(messages_block)},
      {"machines", plain(machines_block)},
      {"settings", plain(settings_block)},
      {"models", plain(models_block)},
      {"commands", plain(commands_block)}};
  return list;
}

PageTexts page_texts(const ReportInput& input) {
  return {input.heading(),
          input.author,
          input.date,
          ReportWords::tr("page %1 of %2"),
          ReportWords::tr("simulated, not measured"),
          input.paper};
}

}  // namespace

QStringList report_placeholders() {
  QStringList names;
  for (const Block& block : blocks()) {
    names.append(QString::fromLatin1(block.name));
  }
  names.append(screen_section);
  return names;
}

ReportTemplate load_report_template(const QString& file) {
  const QString name = file.isEmpty() ? shipped_template() : file;
  return {with_pictures_inside(read_template(name), name), name, report_placeholders()};
}

ReportPage report_page(const ReportInput& asked, const ReportTemplate& page, ReportFormat format,
                       Progress* progress) {
  const auto wanted = [&asked, names = page.placeholders(asked.with)](const char* name) {
    return names.contains(QLatin1String(name)) && !asked.without.contains(QLatin1String(name));
  };
  ReportInput input = with_recommended_run(asked);
  if (wanted("notes")) {
    for (std::size_t i = 0; i < input.annotations.size(); ++i) {
      input.annotations[i].text.prepend(note_number(i));
    }
  }
  if (wanted("contour_histogram") || wanted("contour_places") || wanted("contour_place_views")) {
    input = with_contour_reports(std::move(input), progress);
  }
  if (wanted("circles") || wanted("circle_plots")) {
    input = with_circles(std::move(input), progress);
  }
  const bool finds = wanted("losses") || wanted("cards") || wanted("motion_windows");
  if (finds || wanted("time_use") || wanted("time_places") || wanted("time_changes")) {
    const bool tries =
        (wanted("losses") || wanted("time_changes")) && !input.without.contains("time_changes");
    input = with_time_report(std::move(input), tries, progress);
  }
  ReportPage result{{}, ReportPictures(progress)};
  result.html = page.filled(
      [&](const QString& name) {
        if (name == screen_section) {
          return format == ReportFormat::html ? name : QString();
        }
        for (const Block& block : blocks()) {
          if (name == QLatin1String(block.name) && !input.without.contains(name)) {
            return block.make(input, result.pictures);
          }
        }
        return QString();
      },
      asked.with);
  result.html = with_filled_pages(with_figure_numbers(result.html), result.pictures, input.paper);
  return result;
}

std::string file_of(const ReportPage& page, ReportFormat format, const PageTexts& texts) {
  const SharedPictureWindow window;
  switch (format) {
    case ReportFormat::pdf:
      return paged_pdf(page.html, page.pictures, texts);
    case ReportFormat::pages:
      return recorded_pages(page.html, page.pictures, texts).bytes();
    case ReportFormat::html:
      break;
  }
  return report_html(page.html, page.pictures);
}

std::string make_report(const ReportInput& input, const ReportTemplate& page, ReportFormat format,
                        Progress* progress) {
  const ReportPage report = report_page(input, page, format, progress);
  return file_of(report, format, page_texts(input));
}

std::vector<std::string> make_report_pictures(const ReportInput& input, const ReportTemplate& page,
                                              double dpi, Progress* progress) {
  const SharedPictureWindow window;
  const ReportPage report = report_page(input, page, ReportFormat::pdf, progress);
  return paged_pictures(report.html, report.pictures, page_texts(input), dpi);
}

}  // namespace feedscope::ui
