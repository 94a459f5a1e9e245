#include "ui/runs/comparison_layout.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/runs/cause_bar.h"
#include "ui/shared/plot_grid.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {

namespace {

constexpr double margin = 16;
constexpr double title_height = 28;
constexpr double legend_row = 20;
constexpr double max_legend_width = 240;
constexpr double legend_gap = 10;
constexpr double headings_height = 34;
constexpr double axis_height = 40;
constexpr double min_row = 16;
constexpr double natural_row = 26;
constexpr double largest_row = 36;
constexpr double model_gap = 0.35;    // between models if one has several runs, in rows
constexpr double machine_gap = 0.35;  // between machines, in rows
constexpr double bar_share = 0.74;
constexpr double column_gap = 18;
constexpr double max_name_width = 160;
constexpr double headroom = 1.02;
constexpr double tick_distance = 65;

struct Comparison {
  Q_DECLARE_TR_FUNCTIONS(feedscope::ui::ComparisonChart)
};

template <typename Visit>
void for_each_bar(const ComparisonBars& bars, Visit visit) {
  for (const MachineBars& machine : bars.machines) {
    for (const ComparisonBar& bar : machine.bars) {
      visit(bar);
    }
  }
}

/// Whether a model of a machine has several runs, so that a gap between models helps.
bool has_families(const MachineBars& machine) {
  return std::ranges::adjacent_find(machine.bars, {}, &ComparisonBar::model) != machine.bars.end();
}

bool begins_family(const MachineBars& machine, std::size_t bar) {
  return bar > 0 && has_families(machine) && machine.bars[bar].model != machine.bars[bar - 1].model;
}

/// Height of all rows and machine lines, in rows.
double row_units(const ComparisonBars& bars) {
  double units = -machine_gap;
  for (const MachineBars& machine : bars.machines) {
    units += machine_gap + 1;
    for (std::size_t i = 0; i < machine.bars.size(); ++i) {
      units += begins_family(machine, i) ? 1 + model_gap : 1;
    }
  }
  return units;
}

/// Height without the rows.
double fixed_height(double legend_rows) {
  return 2 * margin + title_height + legend_rows * legend_row + legend_gap + headings_height + axis_height;
}

std::vector<QString> legend_texts(const ComparisonBars& bars) {
  std::vector<QString> texts = cause_legend(bars);
  if (bars.lines_refused) {
    texts.push_back(Comparison::tr("without refused lines"));
  }
  texts.push_back(Comparison::tr("programmed time"));
  return texts;
}

/// Places entries in rows from the left, as many in each as fit.
std::vector<QRectF> lay_legend(const std::vector<QString>& texts, double width,
                               const QFontMetricsF& metrics) {
  std::vector<double> widths;
  for (const QString& text : texts) {
    widths.push_back(
        std::min(max_legend_width - column_gap, legend_swatch + std::ceil(metrics.horizontalAdvance(text))));
  }
  const QRectF area(margin, margin + title_height, width - 2 * margin, legend_row);
  return entries_in_rows(widths, area, legend_row, legend_row, column_gap);
}

double legend_rows(const std::vector<QRectF>& entries) {
  return entries.empty() ? 0 : (entries.back().top() - entries.front().top()) / legend_row + 1;
}

TextColumn model_column(const ComparisonBars& bars) {
  TextColumn column{QString(), Comparison::tr("model"), {}, Qt::AlignLeft};
  for (const MachineBars& machine : bars.machines) {
    for (std::size_t i = 0; i < machine.bars.size(); ++i) {
      const bool told = i > 0 && machine.bars[i].model == machine.bars[i - 1].model;
      column.texts.push_back(told ? QString() : QString::fromStdString(machine.bars[i].model));
    }
  }
  return column;
}

template <typename Text>
TextColumn column_of(const ComparisonBars& bars, const QString& heading, const QString& below, Text text) {
  TextColumn column{heading, below, {}};
  for_each_bar(bars, [&](const ComparisonBar& bar) { column.texts.push_back(text(bar)); });
  return column;
}

TextColumn letter_column(const ComparisonBars& bars) {
  TextColumn column{QString(), QString(), {}, Qt::AlignLeft};
  for (std::size_t row = 0; row < bars.count(); ++row) {
    column.texts.push_back(bars.count() > 1 ? run_letter(row) : QString());
  }
  return column;
}

std::vector<TextColumn> name_columns(const ComparisonBars& bars) {
  return {letter_column(bars), model_column(bars),
          column_of(bars, Comparison::tr("tolerance"), with_unit_of({}, Dimension::length).trimmed(),
                    [](const ComparisonBar& bar) {
                      const auto number = [](double mm) {
                        return unit_system() == UnitSystem::metric
                                   ? QLocale().toString(mm, 'g', QLocale::FloatingPointShortest)
                                   : QLocale().toString(in_shown_unit(mm, Dimension::length), 'g', 5);
                      };
                      return !bar.tolerance ? QStringLiteral("–")
                             : bar.tolerance->is_range()
                                 ? QStringLiteral("%1 … %2").arg(number(bar.tolerance->min),
                                                                 number(bar.tolerance->max))
                                 : number(bar.tolerance->max);
                    })};
}

/// The figures of a run; none if the control refuses the program or the machine cannot reach it.
template <typename Text>
TextColumn figure_column(const ComparisonBars& bars, const QString& heading, const QString& below,
                         Text text) {
  return column_of(bars, heading, below, [&](const ComparisonBar& bar) {
    return bar.refused || bar.out_of_reach ? QStringLiteral("–") : text(bar);
  });
}

std::vector<TextColumn> figure_columns(const ComparisonBars& bars) {
  const QLocale locale;
  std::vector<TextColumn> columns{
      column_of(bars, QString(), Comparison::tr("cycle time"), [&](const ComparisonBar& bar) {
        return bar.refused        ? Comparison::tr("refused")
               : bar.out_of_reach ? Comparison::tr("out of reach")
                                  : clock_text(bar.cycle_time);
      })};
  columns.push_back(figure_column(
      bars, Comparison::tr("relative to"), QStringLiteral("cam"), [&](const ComparisonBar& bar) {
        return bar.lines_not_run > 0  // another program than the one of cam
                   ? QStringLiteral("–")
                   : QStringLiteral("× %1").arg(locale.toString(bar.against_cam, 'f', 3));
      }));
  columns.push_back(figure_column(
      bars, bars.actual ? Comparison::tr("actual contour error") : Comparison::tr("contour error"),
      with_unit_of({}, Dimension::error).trimmed(),
      [&](const ComparisonBar& bar) { return number_text(bar.contour_error, Dimension::error); }));
  if (bars.lines_refused) {
    columns.push_back(
        column_of(bars, Comparison::tr("refused lines"), QString(), [&](const ComparisonBar& bar) {
          return bar.lines_not_run > 0 ? locale.toString(bar.lines_not_run) : QStringLiteral("–");
        }));
  }
  return columns;
}

double width_of(const TextColumn& column, const QFontMetricsF& metrics) {
  double width = std::max(metrics.horizontalAdvance(column.heading), metrics.horizontalAdvance(column.below));
  for (const QString& text : column.texts) {
    width = std::max(width, metrics.horizontalAdvance(text));
  }
  return std::ceil(width);
}

/// Shortens the texts of a column to its width.
void fit_texts(TextColumn& column, const QFontMetricsF& metrics) {
  for (QString& text : column.texts) {
    text = metrics.elidedText(text, Qt::ElideMiddle, column.right - column.left);
  }
}

/// Places columns from the left and returns the end of the last.
double lay_columns(std::vector<TextColumn>& columns, double left, const QFontMetricsF& metrics) {
  for (TextColumn& column : columns) {
    column.left = left;
    column.right = left + std::min(max_name_width, width_of(column, metrics));
    fit_texts(column, metrics);
    left = column.right + column_gap;
  }
  return left;
}

void move_columns(std::vector<TextColumn>& columns, double distance) {
  for (TextColumn& column : columns) {
    column.left += distance;
    column.right += distance;
  }
}

/// Places rows and machine lines from `top` down and returns their end.
double lay_rows(ComparisonLayout& layout, const ComparisonBars& bars, double top, double width, double row) {
  double y = top;
  for (const MachineBars& machine : bars.machines) {
    y += layout.machines.empty() ? 0 : machine_gap * row;
    layout.machines.emplace_back(margin, y, width - 2 * margin, row);
    y += row;
    for (std::size_t i = 0; i < machine.bars.size(); ++i) {
      y += begins_family(machine, i) ? model_gap * row : 0;
      layout.rows.emplace_back(margin, y, width - 2 * margin, row);
      y += row;
    }
  }
  layout.bar_height = std::round(bar_share * row);
  return y;
}

int height_with_rows(double row, const ComparisonBars& bars, int width, const QFont& font) {
  const double rows = legend_rows(lay_legend(legend_texts(bars), width, QFontMetricsF(font)));
  return static_cast<int>(std::ceil(fixed_height(rows) + row * row_units(bars)));
}

}  // namespace

ComparisonLayout lay_out(const ComparisonBars& bars, const QSize& size, const QFont& font) {
  const QFontMetricsF metrics(font);
  ComparisonLayout layout;
  layout.title = QRectF(margin, margin, size.width() - 2 * margin, title_height);
  layout.legend_texts = legend_texts(bars);
  layout.legend = lay_legend(layout.legend_texts, size.width(), metrics);

  const double fixed = fixed_height(legend_rows(layout.legend));
  const double row =
      std::clamp(std::floor((size.height() - fixed) / std::max(1.0, row_units(bars))), min_row, largest_row);
  layout.headings = QRectF(margin, fixed - margin - axis_height - headings_height, size.width() - 2 * margin,
                           headings_height);

  layout.names = name_columns(bars);
  layout.figures = figure_columns(bars);
  const double left = lay_columns(layout.names, margin, metrics);
  const double figures_width = lay_columns(layout.figures, 0, metrics) - column_gap;
  const double right = size.width() - margin - figures_width - column_gap;
  move_columns(layout.figures, size.width() - margin - figures_width);

  const double top = layout.headings.bottom();
  const double bottom = lay_rows(layout, bars, top, size.width(), row);
  layout.plot = QRectF(left, top, right - left, bottom - top);
  layout.axis = QRectF(left, bottom, right - left, axis_height);
  const double most = bars.longest > 0 ? headroom * bars.longest : 1;
  layout.pixels_per_second = layout.plot.width() / most;
  layout.ticks = clock_ticks(0, most, static_cast<int>(layout.plot.width() / tick_distance));
  return layout;
}

int natural_comparison_height(const ComparisonBars& bars, int width, const QFont& font) {
  return height_with_rows(natural_row, bars, width, font);
}

int min_comparison_height(const ComparisonBars& bars, int width, const QFont& font) {
  return height_with_rows(min_row, bars, width, font);
}

int enough_comparison_height(const ComparisonBars& bars, int width) {
  const double entries_a_row = std::max(1.0, std::floor((width - 2 * margin) / max_legend_width));
  const double max_rows = std::ceil(static_cast<double>(max_cause_kinds + 3) / entries_a_row);
  return static_cast<int>(std::ceil(fixed_height(max_rows) + min_row * row_units(bars)));
}

}  // namespace feedscope::ui
