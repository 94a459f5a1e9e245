#include "ui/window/panels/pictures_of_panels.h"

#include <QApplication>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QStringList>
#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/analysis/notes/not_counted.h"
#include "core/base/error.h"
#include "ui/charts/charts_panel.h"
#include "ui/circular/circular_texts.h"
#include "ui/circular/polar_plot.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"
#include "ui/paper/picture_file.h"
#include "ui/report/charts_page.h"
#include "ui/runs/comparison_chart.h"
#include "ui/study/study_chart.h"
#include "ui/study/study_map.h"
#include "ui/theme/offscreen_application.h"
#include "ui/window/main_window.h"
#include "ui/workbench/reading_faults.h"
#include "ui/workbench/setting_texts.h"

namespace feedscope::ui {

namespace {

constexpr int comparison_width = 1280;

void check_size(PictureSize size, const QSize& least) {
  if (size.width < least.width() || size.height < least.height()) {
    const QString message =
        QStringLiteral("a picture of %1 x %2 pixels is too small; it needs at least %3 x %4");
    throw InputError(
        message.arg(size.width).arg(size.height).arg(least.width()).arg(least.height()).toStdString());
  }
}

[[noreturn]] void refuse_height(std::size_t runs, int height) {
  throw InputError(
      QStringLiteral(
          "%1 runs are too many for one picture; they need a height of %2 pixels, and it may have %3")
          .arg(runs)
          .arg(height)
          .arg(largest_picture_side)
          .toStdString());
}

/// Places of all visible widgets.
std::vector<QRect> places(const QWidget& window) {
  std::vector<QRect> places;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    places.push_back(widget->isVisible() ? widget->geometry() : QRect());
  }
  return places;
}

/// Waits until the layout is stable: a table's rows take their height, then the table its own, then its
/// scroll bar disappears, then its columns widen.
void settle(const QWidget& window) {
  constexpr int enough_rounds = 3;  // without a change
  constexpr int max_rounds = 100;   // ends an endless alternation
  std::vector<QRect> before;
  int same = 0;
  for (int round = 0; round < max_rounds && same < enough_rounds; ++round) {
    QApplication::processEvents();
    std::vector<QRect> now = places(window);
    same = now == before ? same + 1 : 0;
    before = std::move(now);
  }
}

/// `ratio`: pixels per unit, if lower than the widget's.
Picture grab(QWidget& widget, PictureSize size, double ratio = 1) {
  check_size(size, widget.minimumSizeHint().expandedTo(widget.minimumSize()));
  QApplication::processEvents();  // Qt Charts lays its axes out in the next turn of the event loop
  const QImage image = widget.grab().toImage();
  return picture_of(ratio < 1 ? image.scaled((QSizeF(widget.size()) * ratio).toSize(), Qt::IgnoreAspectRatio,
                                             Qt::SmoothTransformation)
                              : image);
}

/// Items that the cycle times do not contain, with their machines if these differ.
template <class Runs>
QString not_counted_details(const Runs& runs) {
  std::vector<std::pair<QString, QStringList>> all;
  for (const auto& run : runs) {
    const QString text = in_language(not_counted_note(run.summary.not_counted));
    auto known = std::ranges::find(all, text, &std::pair<QString, QStringList>::first);
    if (known == all.end()) {
      known = all.insert(all.end(), {text, {}});
    }
    const QString machine = QString::fromStdString(run.setup.machine.name);
    if (!known->second.contains(machine)) {
      known->second.append(machine);
    }
  }
  QStringList texts;
  for (const auto& [text, machines] : all) {
    if (!text.isEmpty()) {
      texts.append(
          all.size() == 1 ? text : QStringLiteral("%1 (%2)").arg(text, machines.join(QStringLiteral(", "))));
    }
  }
  return texts.join(QStringLiteral(" · "));
}

/// The value that an assignment has given to a setup; none where it does not apply to it.
std::optional<SettingValue> assigned_value(const std::string& key, const Setup& setup) {
  constexpr std::size_t after_axis = 2;  // "X.jerk"
  if (key.size() > after_axis && key[1] == '.') {
    const bool has_axis = axis_names(setup.machine).find(key[0]) != std::string::npos;
    return has_axis ? std::optional(axis_value(setup.machine, key[0], key.substr(after_axis))) : std::nullopt;
  }
  return setup.settings.has(key) ? std::optional(setup.settings.value(key)) : std::nullopt;
}

/// "X Jerk 5 m/s³"; of what no run reads, the assignment itself.
template <class Runs>
QStringList assignment_texts(const std::vector<std::string>& assignments, const Runs& runs) {
  std::map<std::string, SettingValue> values;
  QStringList unread;
  for (const std::string& assignment : assignments) {
    const std::string key = assigned_key(assignment);
    std::optional<SettingValue> value;
    for (const auto& run : runs) {
      value = value ? value : assigned_value(key, run.setup);
    }
    if (value) {
      values[key] = *value;
    } else {
      unread.append(QString::fromStdString(assignment));
    }
  }
  return setting_texts(values) + unread;
}

template <class Runs>
QString comparison_details(const LoadedProgram& program, const Runs& runs,
                           const std::vector<std::string>& assignments) {
  const QString path = ComparisonChart::tr("path length %1")
                           .arg(amount_text(program.toolpath->length(), Dimension::length, 1));
  const QStringList set = assignment_texts(assignments, runs);
  const QString details =
      set.isEmpty() ? path : ComparisonChart::tr("%1, with %2").arg(path, set.join(QStringLiteral(", ")));
  QStringList parts{reading_faults_text(*program.program), not_counted_details(runs), details};
  parts.removeAll(QString());
  return parts.join(QStringLiteral(" · "));
}

}  // namespace

Picture draw_window(const Run& run, PictureSize size, const WindowLook& look) {
  // Below one pixel per unit, Qt draws only parts of a window.
  const OffscreenApplication application(look.theme, std::max(1.0, look.pixel_ratio));
  if (look.language != languages().front()) {
    speak(look.language);
  }
  Workbench model(shipped_machines(), run.setup);
  model.show(run);
  MainWindow window(model, RenderBackend::software);
  window.setAttribute(Qt::WA_DontShowOnScreen);
  window.resize(size.width, size.height);
  window.show();
  QApplication::processEvents();
  window.scene().scene().set_standard_view(look.view);
  if (look.prepare) {
    look.prepare(window, model);
  }
  while (model.busy() || window.busy()) {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  settle(window);
  window.part<ChartsPanel>().refresh();
  window.scenes().rest();
  return grab(window, size, look.pixel_ratio);
}

namespace {

/// Keeps English unchanged: it has a decimal point without group separators.
void speak_other(const QString& language) {
  if (language != languages().front()) {
    speak(language);
  }
}

}  // namespace

Picture draw_charts(const Run& run, PictureSize size) {
  const OffscreenApplication application;
  ChartsPage page;
  page.set_run(run);
  page.prepare({size.width, size.height});
  return grab(page, size);
}

void check_comparison_size(std::span<const Setup> setups, std::optional<PictureSize> wanted) {
  const int width = wanted ? wanted->width : comparison_width;
  std::vector<ComparedRun> runs;
  for (const Setup& setup : setups) {
    runs.push_back({setup, {}});
  }
  const QSize least(min_comparison_width, enough_comparison_height(comparison_bars(runs), width));
  if (wanted) {
    check_size(*wanted, least);
  } else if (least.height() > largest_picture_side) {
    refuse_height(setups.size(), least.height());
  }
}

Picture draw_comparison(const LoadedProgram& program, std::span<const ComparedRun> runs,
                        const std::vector<std::string>& assignments, std::optional<PictureSize> wanted,
                        const QString& language) {
  const OffscreenApplication application;
  speak_other(language);
  ComparisonChart chart;
  chart.set_comparison(program_file_name(*program.program), comparison_details(program, runs, assignments),
                       comparison_bars(runs));
  chart.ensurePolished();
  const int natural = natural_comparison_height(chart.bars(), comparison_width, chart.font());
  const PictureSize size =
      wanted.value_or(PictureSize{comparison_width, std::min(natural, largest_picture_side)});
  chart.resize(size.width, size.height);
  return grab(chart, size);
}

namespace {

Picture draw_maps(const LoadedProgram& program, const Study& study,
                  const std::vector<std::string>& assignments, std::optional<PictureSize> wanted) {
  StudyMaps maps = study_maps(study);
  const QSize natural = StudyMapPicture::natural_size(maps.maps.size());
  const QSize size = wanted ? QSize(wanted->width, wanted->height) : natural;
  QImage image(size, QImage::Format_RGB888);
  QPainter painter(&image);
  StudyMapPicture(program_file_name(*program.program), comparison_details(program, study.runs, assignments),
                  std::move(maps), QApplication::font())
      .paint(painter, size);
  return picture_of(image);
}

}  // namespace

void check_study_size(std::span<const Sweep> sweeps, std::size_t runs, std::optional<PictureSize> wanted) {
  if (sweeps.size() < 2) {
    return;
  }
  const std::size_t maps = runs / (sweeps[0].values.size() * sweeps[1].values.size());
  if (wanted) {
    check_size(*wanted, StudyMapPicture::least_size(maps));
  } else if (const int height = StudyMapPicture::natural_size(maps).height(); height > largest_picture_side) {
    refuse_height(runs, height);
  }
}

Picture draw_study(const LoadedProgram& program, const Study& study,
                   const std::vector<std::string>& assignments, std::optional<PictureSize> wanted,
                   const QString& language) {
  const OffscreenApplication application;
  speak_other(language);
  if (study.sweeps.size() > 1) {
    return draw_maps(program, study, assignments, wanted);
  }
  StudyChart chart;
  chart.set_study(program_file_name(*program.program), comparison_details(program, study.runs, assignments),
                  study_curves(study));
  chart.ensurePolished();
  const PictureSize size = wanted.value_or(PictureSize{chart.sizeHint().width(), chart.sizeHint().height()});
  chart.resize(size.width, size.height);
  return grab(chart, size);
}

std::string circular_file(const std::string& name, const Setup& setup, const std::vector<CircularTest>& tests,
                          std::optional<PictureSize> wanted, const QString& language) {
  PictureSpec spec;
  spec.format = picture_format_of(name);
  const OffscreenApplication application;
  speak_other(language);
  PolarPlot plot;
  plot.set_tests(circular_picture_title(), circular_picture_details(setup, tests.front().actual), tests);
  plot.ensurePolished();
  const PictureSize size = wanted.value_or(PictureSize{plot.sizeHint().width(), plot.sizeHint().height()});
  check_size(size, plot.least_picture());
  spec.size = QSizeF(size.width, size.height);
  spec.title = circular_picture_title();
  return make_picture(
      spec, [&plot, &spec](QPainter& painter) { plot.draw(painter, QRectF(QPointF(), spec.size)); });
}

}  // namespace feedscope::ui
