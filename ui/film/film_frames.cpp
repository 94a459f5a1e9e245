#include "ui/film/film_frames.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/paper/picture_file.h"
#include "ui/scene/picture.h"
#include "ui/theme/fonts.h"

namespace feedscope::ui {

namespace {

constexpr double caption_height = 28;  // all of this at text scale 1 [1/96 inch]
constexpr int caption_pixels = 14;
constexpr double caption_margin = 12;
constexpr double caption_gap = 28;
constexpr double charts_share = 0.47;                   // of the height
constexpr QSizeF enough_for_a_chart_of_film(640, 110);  // smaller charts are laid out larger and shrunk
constexpr QSizeF least_view(320, 160);
constexpr double usual_trail = 2;  // [s] of the film

/// `input` with charts over the film's range.
ReportInput for_film(ReportInput input, const FilmTimes& times) {
  input.charts.time = Interval{times.from, times.to};
  input.charts.abscissa = Abscissa::time;
  input.charts.second_cursor.reset();
  return input;
}

double whole_pixels(double length, double ratio) {
  return std::round(length * ratio) / ratio;
}

}  // namespace

FilmFrames::FilmFrames(const ReportInput& input, const FilmTimes& times, const FilmLook& look)
    : input_(for_film(input, times)),
      times_(times),
      look_(look),
      text_scale_(scale_for({look.picture.size.toSize().width(), look.picture.size.toSize().height()})),
      scene_(input_, input_.current, look.picture.theme) {
  lay_out();
  if (look_.charts) {
    make_charts();
  }
  scene_.scene().set_tool(input_.scene.tool);
  scene_.scene().set_trail(look_.trail.value_or(usual_trail * times_.speed));
}

FilmFrames::~FilmFrames() = default;

void FilmFrames::lay_out() {
  const QSizeF size = look_.picture.size;
  const double ratio = look_.picture.pixel_ratio;
  const double caption = whole_pixels(caption_height * text_scale_, ratio);
  const double charts = look_.charts ? whole_pixels(charts_share * size.height(), ratio) : 0;
  const double view = size.height() - caption - charts;
  if (size.width() < least_view.width() || view < least_view.height()) {
    throw InputError(look_.charts ? message(NC_("core",
                                                "a film of {:.0f} x {:.0f} units is too small for the view "
                                                "and the charts; use a larger --size or a smaller --scale"),
                                            size.width(), size.height())
                                  : message(NC_("core",
                                                "a film of {:.0f} x {:.0f} units is too small; use a larger "
                                                "--size or a smaller --scale"),
                                            size.width(), size.height()));
  }
  view_ = QRectF(0, 0, size.width(), view);
  caption_ = QRectF(0, view, size.width(), caption);
  below_ = QRectF(0, view + caption, size.width(), charts);
}

void FilmFrames::make_charts() {
  charts_ = std::make_unique<ChartsPage>();
  charts_->set_runs(input_, input_.current);
  charts_->hide_title();
  charts_->set_cursor(times_.from);  // the values in the headers take room
  const QSizeF& enough = enough_for_a_chart_of_film;
  charts_scale_ = std::min(
      {text_scale_, below_.height() / (charts_->count() * enough.height()), below_.width() / enough.width()});
  charts_->prepare((below_.size() / charts_scale_).toSize(), charts_scale_ * look_.picture.pixel_ratio);
}

QImage FilmFrames::frame(std::size_t k) {
  const double ratio = look_.picture.pixel_ratio;
  const State state = run().trajectory->state(times_.time(k));
  scene_.scene().set_cursor(state);
  QImage image((look_.picture.size * ratio).toSize(), QImage::Format_RGB32);
  image.fill(QApplication::palette().color(QPalette::Window));
  QPainter painter;
  begin_units(painter, image, ratio);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  scene_.paint(painter, view_, {ratio, text_scale_});
  draw_caption(painter, state);
  if (charts_) {
    draw_charts(painter, state.time);
  }
  painter.end();
  image.setDevicePixelRatio(1);
  return image;
}

/// Draws time, feed, program line, and on the right the speed of the film, each at the same place in every
/// frame.
void FilmFrames::draw_caption(QPainter& painter, const State& state) const {
  const QLocale locale;
  const auto pixels = static_cast<int>(std::lround(caption_pixels * text_scale_));
  const QFont font = paper_font(pixels, true);
  const QFontMetricsF metrics(font);
  const double gap = caption_gap * text_scale_;
  const double end = caption_.right() - caption_margin * text_scale_;
  double left = caption_.left() + caption_margin * text_scale_;
  painter.setPen(QApplication::palette().color(QPalette::WindowText));
  const auto write = [&](const QString& text, double room, Qt::Alignment side) {
    painter.drawText(QRectF(left, caption_.top(), room, caption_.height()), side | Qt::AlignVCenter, text);
  };
  /// `widest`: the widest of these texts in any frame.
  const auto column = [&](const QString& text, const QString& widest) {
    const double room = std::max(metrics.horizontalAdvance(widest), metrics.horizontalAdvance(text));
    write(text, room, Qt::AlignRight);
    left += room + gap;
  };
  painter.setFont(font);
  const double duration = run().trajectory->duration();
  const auto time_text = [&](double time) {
    return tr("%1 / %2").arg(clock_text(time), clock_text(duration));
  };
  column(time_text(state.time), time_text(duration));
  column(amount_text(state.speed, Dimension::feed), amount_text(run().summary.peak_feed, Dimension::feed));

  const QString speed = QStringLiteral("× ") + locale.toString(times_.speed, 'g', 4);
  const double speed_room = metrics.horizontalAdvance(speed);
  painter.drawText(QRectF(end - speed_room, caption_.top(), speed_room, caption_.height()),
                   Qt::AlignRight | Qt::AlignVCenter, speed);

  QFont fixed = font;
  fixed.setBold(false);
  fixed.setFamilies({QStringLiteral("DejaVu Sans Mono")});
  painter.setFont(fixed);
  const double room = end - speed_room - gap - left;
  const QString code =
      QString::fromStdString(input_.program().program->source->utf8_line(state.line)).simplified();
  const QString line = tr("Line %1: %2").arg(QString::number(state.line), code);
  if (room > 0) {
    write(QFontMetricsF(fixed).elidedText(line, Qt::ElideRight, room), room, Qt::AlignLeft);
  }
}

void FilmFrames::draw_charts(QPainter& painter, double time) {
  charts_->set_cursor(time);
  painter.save();
  painter.translate(below_.topLeft());
  painter.scale(charts_scale_, charts_scale_);
  charts_->draw(painter);
  painter.restore();
}

}  // namespace feedscope::ui
