#include "ui/report/sheet.h"

#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QPainter>
#include <QTextDocument>
#include <algorithm>

#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/notes/remarks.h"
#include "core/analysis/run/program_facts.h"
#include "core/analysis/study/recommendation.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "ui/charts/cause_strip.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"
#include "ui/language/texts.h"
#include "ui/paper/html_table.h"
#include "ui/report/blocks/report_decision.h"
#include "ui/report/charts_page.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_tables.h"
#include "ui/report/report_words.h"
#include "ui/report/scene_picture.h"
#include "ui/theme/fonts.h"
#include "ui/units/unit_system.h"
#include "ui/workbench/reading_faults.h"

namespace feedscope::ui {

namespace {

constexpr double margin = 38;
constexpr double gap = 14;
constexpr double title_height = 58;
constexpr double figures_height = 50;
constexpr double footer_height = 16;
constexpr std::size_t max_runs = 12;                  // in the table
constexpr QSizeF enough_for_a_chart(640, 400.0 / 3);  // smaller charts are laid out larger and shrunk

struct Colours {
  QColor title, text, muted, rule, tile, paper, alarm;
};

Colours colours_of(ThemeKind theme) {
  return theme == ThemeKind::dark
             ? Colours{"#9cc7f0", "#e3e6e9", "#a0a6ad", "#4a4f55", "#2d3136", "#1b1d20", "#ff8a70"}
             : Colours{"#16324f", "#22262a", "#5a6068", "#c8cdd2", "#f1f4f7", "#ffffff", "#c62818"};
}

class SheetPainter {
 public:
  SheetPainter(QPainter& painter, const QSizeF& size, const ReportInput& input, const SheetLook& look)
      : painter_(painter), size_(size), input_(input), look_(look), colours_(colours_of(look.theme)) {}

  void paint() {
    if (!look_.transparent) {
      painter_.fillRect(QRectF(QPointF(), size_), colours_.paper);
    }
    const QRectF page = QRectF(QPointF(), size_).adjusted(margin, margin - 6, -margin, -margin + 6);
    draw_title({page.left(), page.top(), page.width(), title_height});
    draw_figures({page.left(), page.top() + title_height + 4, page.width(), figures_height});
    draw_footer({page.left(), page.bottom() - footer_height, page.width(), footer_height});
    const double top = page.top() + title_height + figures_height + gap;
    const QRectF room(page.left(), top, page.width(), page.bottom() - footer_height - 8 - top);
    size_.width() >= size_.height() ? lie(room) : stand(room);
  }

 private:
  /// Landscape: view and texts side by side, charts below.
  void lie(const QRectF& room) {
    const double upper = 0.5 * room.height();
    const double left = 0.60 * room.width();
    draw_view({room.left(), room.top(), left, upper});
    draw_html({room.left() + left + gap, room.top(), room.width() - left - gap, upper},
              table_html() + facts_html() + causes_html());
    draw_charts({room.left(), room.top() + upper + gap, room.width(), room.height() - upper - gap});
  }

  /// Portrait: view, charts and texts one above the other.
  void stand(const QRectF& room) {
    constexpr double below_table = 150;
    const double table = 40 + 22 * static_cast<double>(std::min(input_.runs.size(), max_runs + 1));
    const double lower = std::min(table + below_table, 0.36 * room.height());
    const double each = (room.height() - lower - 2 * gap) / 2;
    draw_view({room.left(), room.top(), room.width(), each});
    draw_charts({room.left(), room.top() + each + gap, room.width(), each});
    const double top = room.top() + 2 * (each + gap);
    const double table_height = lower - below_table;
    draw_html({room.left(), top, room.width(), table_height}, table_html());
    const double half = (room.width() - gap) / 2;
    draw_html({room.left(), top + table_height, half, below_table}, facts_html());
    draw_html({room.left() + half + gap, top + table_height, half, below_table}, causes_html());
  }

  void write(const QRectF& room, const QFont& font, const QColor& colour, Qt::Alignment side,
             const QString& text) {
    painter_.setFont(font);
    painter_.setPen(colour);
    painter_.drawText(room, side | Qt::AlignVCenter | Qt::TextDontClip,
                      QFontMetricsF(font).elidedText(text, Qt::ElideMiddle, room.width()));
  }

  void draw_title(const QRectF& room) {
    const Setup& setup = input_.run().shown->run.setup;
    const QString faults = reading_faults_text(*input_.program().program);
    const QFont bold = paper_font(13, true);
    const double beside = faults.isEmpty() ? 0 : QFontMetricsF(bold).horizontalAdvance(faults) + 20;
    write({room.left(), room.top(), room.width() - beside, 30}, paper_font(22, true), colours_.title,
          Qt::AlignLeft, input_.heading());
    write({room.left(), room.top(), room.width(), 30}, bold, colours_.alarm, Qt::AlignRight, faults);
    QStringList right;
    for (const QString& part : {input_.author, date_text(input_.date)}) {
      if (!part.isEmpty()) {
        right.append(part);
      }
    }
    const QString told = right.join(QStringLiteral(" · "));
    const QFont small = paper_font(11);
    const double used = told.isEmpty() ? 0 : QFontMetricsF(small).horizontalAdvance(told) + 20;
    QStringList left{program_file_name(*input_.program().program),
                     QString::fromStdString(setup.machine.name)};
    if (!setup.machine.control.empty()) {
      left.append(QString::fromStdString(setup.machine.control));
    }
    const QString run = lettered_title(input_, input_.current);
    if (const QString common = common_name(input_); common != run && !common.isEmpty()) {
      left.append(common);
    }
    left.append(run);
    const double line = room.top() + 32;
    write({room.left(), line, room.width() - used, 18}, small, colours_.muted, Qt::AlignLeft,
          left.join(QStringLiteral(" · ")));
    write({room.left(), line, room.width(), 18}, small, colours_.muted, Qt::AlignRight, told);
    painter_.setPen(QPen(colours_.rule, 1));
    painter_.drawLine(room.bottomLeft(), room.bottomRight());
  }

  void draw_figures(const QRectF& room) {
    const Summary& summary = input_.run().shown->run.summary;
    const double ratio = summary.programmed_time > 0 ? summary.cycle_time / summary.programmed_time : 0;
    const bool refused = is_refused(input_.run().shown->run);
    const auto shown = [&](const QString& figure) { return refused ? QStringLiteral("–") : figure; };
    const std::pair<QString, QString> figures[] = {
        {ReportWords::tr("cycle time"),
         refused ? ReportWords::tr("refused") : clock_text(summary.cycle_time)},
        {ReportWords::tr("× programmed time"),
         ratio > 0 ? shown(significant_number(ratio, 3)) : QStringLiteral("–")},
        {ReportWords::tr("mean feed with rapids, %1").arg(unit_of(Dimension::feed)),
         shown(fixed(summary.mean_feed, Dimension::feed))},
        {ReportWords::tr("peak feed, %1").arg(unit_of(Dimension::feed)),
         shown(fixed(summary.peak_feed, Dimension::feed))},
        {summary.actual ? ReportWords::tr("actual contour error, %1").arg(unit_of(Dimension::error))
                        : ReportWords::tr("contour error, %1").arg(unit_of(Dimension::error)),
         shown(error_number(deciding_error(summary)))}};
    const double width = (room.width() - 4 * 8) / 5;
    double left = room.left();
    for (const auto& [name, value] : figures) {
      const QRectF tile(left, room.top(), width, room.height());
      painter_.setPen(Qt::NoPen);
      painter_.setBrush(colours_.tile);
      painter_.drawRoundedRect(tile, 4, 4);
      painter_.setBrush(Qt::NoBrush);
      write({left + 12, tile.top() + 6, width - 20, 22}, paper_font(16, true), colours_.text, Qt::AlignLeft,
            value);
      write({left + 12, tile.top() + 29, width - 20, 14}, paper_font(10), colours_.muted, Qt::AlignLeft,
            name);
      left += width + 8;
    }
  }

  void draw_footer(const QRectF& room) {
    const QString command = input_.commands.value(0);
    constexpr int smallest = 3;  // [1/96 inch]
    const int wrapped = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWrapAnywhere;
    int pixels = 9;
    while (pixels > smallest &&
           QFontMetricsF(paper_font(pixels)).boundingRect(room, wrapped, command).height() > room.height()) {
      --pixels;  // a truncated command would not run
    }
    painter_.setFont(paper_font(pixels));
    painter_.setPen(colours_.muted);
    painter_.drawText(room, wrapped | Qt::TextDontClip, command);
    write(room, paper_font(9), colours_.muted, Qt::AlignRight,
          input_.commands.isEmpty() ? QStringLiteral("Feedscope %1").arg(QStringLiteral(FEEDSCOPE_VERSION))
                                    : QString());
  }

  void draw_view(const QRectF& room) {
    ScenePicture picture(input_, input_.current, look_.theme, look_.transparent);
    picture.paint(painter_, room, {look_.pixel_ratio, 0.85});
    draw_frame(room);
  }

  void draw_charts(const QRectF& room) {
    ChartsPage page;
    page.set_runs(input_, input_.current);
    page.hide_title();
    page.set_background(colours_.paper);
    const double shrunk = std::min({1.0, room.height() / (page.count() * enough_for_a_chart.height()),
                                    room.width() / enough_for_a_chart.width()});
    page.prepare((room.size() / shrunk).toSize(), shrunk * look_.pixel_ratio);
    painter_.save();
    painter_.translate(room.topLeft());
    painter_.scale(shrunk, shrunk);
    page.draw(painter_, false);
    painter_.restore();
    draw_frame(room);
  }

  void draw_frame(const QRectF& room) {
    painter_.setPen(QPen(colours_.rule, 1));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRect(room);
  }

  /// Actual error if drives move the axes in any run.
  QString error_title() const {
    const bool actual = std::ranges::any_of(
        input_.runs, [](const ReportRun& run) { return summary_of(run).actual.has_value(); });
    return actual ? ReportWords::tr("Actual contour error") : ReportWords::tr("Contour error");
  }

  QString table_html() const {
    HtmlTable table("lrrrr", {40, 17, 13, 15, 15});
    table.add_head({ReportWords::tr("Run"), ReportWords::tr("Cycle time"), ReportWords::tr("To first [%]"),
                    with_unit_of(ReportWords::tr("Mean feed with rapids"), Dimension::feed),
                    with_unit_of(error_title(), Dimension::error)});
    const Run& first_run = input_.runs.front().shown->run;
    const double first = is_refused(first_run) ? 0 : first_run.summary.cycle_time;
    for (std::size_t i = 0; i < std::min(input_.runs.size(), max_runs); ++i) {
      if (is_refused(input_.runs[i].shown->run)) {
        table.add({run_label(input_, i), ReportWords::tr("refused"), QStringLiteral("–"), QStringLiteral("–"),
                   QStringLiteral("–")});
        continue;
      }
      const Summary& summary = input_.runs[i].shown->run.summary;
      table.add(
          {run_label(input_, i), clock_text(summary.cycle_time),
           i == 0 || !(first > 0) ? QStringLiteral("–") : signed_percent(summary.cycle_time / first - 1),
           fixed(summary.mean_feed, Dimension::feed), error_number(deciding_error(summary))});
    }
    if (input_.runs.size() > max_runs) {
      table.add({ReportWords::tr("and %1 more").arg(input_.runs.size() - max_runs)});
    }
    return table.html();
  }

  QString facts_html() const {
    const Program& program = *input_.program().program;
    const ProgramFacts facts = facts_of(program, *input_.runs.front().shown->run.path);
    HtmlTable table("ll", {30, 70});
    table.add({ReportWords::tr("Program"),
               ReportWords::tr("%1 blocks, path %2 %3")
                   .arg(program.block_count)
                   .arg(fixed(facts.path_length, Dimension::length, 1), unit_of(Dimension::length))});
    table.add({ReportWords::tr("Programmed feeds"), programmed_feeds_text(facts)});
    const Run& run = input_.run().shown->run;
    const ModelInfo& model = run.setup.model->info();
    table.add({ReportWords::tr("Control model"), html_text(core_text(model.title))});
    QString html = table.html();
    for (const Message& text :
         texts_about(remarks(run, unit_system()), {Remark::About::validity, Remark::About::not_counted})) {
      html += QStringLiteral("<p>%1</p>").arg(html_text(in_language(text)));
    }
    return html;
  }

  /// The main limiting causes of the current run.
  QString causes_html() const {
    if (is_refused(input_.run().shown->run)) {
      return {};
    }
    constexpr qsizetype most = 5;
    constexpr double worth_a_row = 5e-4;  // of the cycle time: smaller shares would read 0.0 %
    const Summary& summary = input_.run().shown->run.summary;
    HtmlTable table("lrr", {64, 18, 18});
    table.add_head({ReportWords::tr("%1 is limited by").arg(lettered_name(input_, input_.current)),
                    QStringLiteral("s"), QStringLiteral("%")});
    qsizetype rows = 0;
    for (const auto& [kind, time] : time_by_kind(summary)) {
      if (time >= worth_a_row * summary.cycle_time && rows++ < most) {
        table.add(
            {html_text(cause_kind_name(kind)), fixed(time, 2), fixed(100 * time / summary.cycle_time, 1)});
      }
    }
    return table.empty() ? QString() : table.html();
  }

  /// Shrinks the contents to fit.
  void draw_html(const QRectF& room, const QString& contents) {
    QTextDocument document;
    document.setDefaultFont(paper_font(11));
    document.setUseDesignMetrics(true);
    document.setDocumentMargin(0);
    document.setDefaultStyleSheet(
        QStringLiteral("body { color: %1 } table.data { border-collapse: collapse; margin-bottom: 8px }"
                       "p { font-size: 10px; margin: 0 0 4px 0 } th { font-size: 9px; color: %2; "
                       "border-bottom: 1px solid %3 }"
                       "td { font-size: 10px; border-bottom: 1px solid %3 }")
            .arg(colours_.text.name(), colours_.muted.name(), colours_.rule.name()));
    QString html = QStringLiteral("<body>%1</body>").arg(contents);
    document.setHtml(html.replace(QStringLiteral("<wbr>"), QStringLiteral("&#8203;")));
    document.setTextWidth(room.width());
    const double shrunk = std::min(1.0, room.height() / document.size().height());
    if (shrunk < 1) {
      document.setTextWidth(room.width() / shrunk);
    }
    painter_.save();
    painter_.translate(room.topLeft());
    const double fitted = std::min(1.0, room.height() / document.size().height());
    painter_.scale(std::min(shrunk, fitted), std::min(shrunk, fitted));
    QAbstractTextDocumentLayout::PaintContext context;
    context.palette.setColor(QPalette::Text, colours_.text);
    document.documentLayout()->draw(&painter_, context);
    painter_.restore();
  }

  QPainter& painter_;
  QSizeF size_;
  const ReportInput& input_;
  SheetLook look_;
  Colours colours_;
};

}  // namespace

void paint_sheet(QPainter& painter, const QSizeF& size, const ReportInput& input, const SheetLook& look) {
  const double longer = std::max(size.width(), size.height());
  const double shorter = std::min(size.width(), size.height());
  if (longer < min_sheet.width() || shorter < min_sheet.height()) {
    throw InputError(
        message(NC_("core",
                    "a sheet of {:.0f} x {:.0f} units is too small; it needs at least {:.0f} on its longer "
                    "and {:.0f} on its shorter side: use a larger --size or a smaller --scale"),
                size.width(), size.height(), min_sheet.width(), min_sheet.height()));
  }
  SheetPainter(painter, size, input, look).paint();
}

}  // namespace feedscope::ui
