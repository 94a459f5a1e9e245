#include "ui/circular/circular_view.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <numbers>

#include "core/base/error.h"
#include "ui/charts/chart_export.h"
#include "ui/circular/polar_plot.h"
#include "ui/fields/number_box.h"
#include "ui/language/shown_numbers.h"
#include "ui/shared/panel_action.h"

namespace feedscope::ui {
namespace {

constexpr double usual_radius = 30;         // [mm]
constexpr double usual_feed = 6000.0 / 60;  // [mm/s]
constexpr double usual_entry = 10;          // [mm]
constexpr double largest_radius = 1e4;      // [mm]
constexpr double largest_feed = 2000;       // [mm/s]

void set_up(NumberBox& box, Dimension dimension, double value, double largest, int decimals) {
  box.setDecimals(decimals_of(dimension, decimals));
  box.setRange(0, in_shown_unit(largest, dimension));
  box.setValue(in_shown_unit(value, dimension));
  box.setSuffix(' ' + unit_of(dimension));
  box.setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
}

}  // namespace

CircularView::CircularView(Workbench& workbench, QWidget* parent)
    : Panel({QStringLiteral("circular"), tr("Circular test"), Qt::BottomDockWidgetArea, false}, parent),
      workbench_(workbench),
      radius_(new NumberBox(this)),
      feed_(new NumberBox(this)),
      with_entry_(new QCheckBox(tr("&Entry arc"), this)),
      entry_(new NumberBox(this)),
      plane_(new QComboBox(this)),
      run_(new QPushButton(tr("Te&st"), this)),
      message_(new QLabel(this)),
      plot_(new PolarPlot(this)) {
  make_fields();
  make_actions();
  make_layout();
  connect(run_, &QPushButton::clicked, this, [this] { busy() ? job_.cancel() : run(); });
  connect(&workbench_.setup(), &SetupEdit::values_changed, this, &CircularView::forget);
  connect(&workbench_.setup(), &SetupEdit::keys_changed, this, &CircularView::forget);
  show_idle({});
}

void CircularView::make_fields() {
  set_up(*radius_, Dimension::length, usual_radius, largest_radius, 3);
  set_up(*feed_, Dimension::feed, usual_feed, largest_feed, 0);
  set_up(*entry_, Dimension::length, usual_entry, largest_radius, 3);
  radius_->setToolTip(tr("Radius of the circle"));
  feed_->setToolTip(tr("Programmed feed"));
  with_entry_->setToolTip(tr(
      "A quarter circle leads in and one out, as in a bore; without it the circle runs from rest to rest"));
  entry_->setToolTip(tr("Radius of the quarter circles"));
  entry_->setEnabled(false);
  connect(with_entry_, &QCheckBox::toggled, entry_, &QWidget::setEnabled);
  for (const CirclePlane plane : {CirclePlane::xy, CirclePlane::zx, CirclePlane::yz}) {
    plane_->addItem(QString::fromLatin1(info_of(plane).name.data()));
  }
  plane_->setToolTip(tr("Plane of the circle"));
  plane_->setAccessibleName(tr("Plane"));
  run_->setToolTip(tr("Simulate the circle in both directions on this machine and control"));
  message_->setWordWrap(true);
}

void CircularView::make_actions() {
  actions_.append(make_action(this, tr("&Circular test (ISO 230-4) …"),
                              tr("Circularity and radial errors of a circle on this machine and control"), {},
                              [this] { emit attention_wanted(); }));
  actions_.append(make_action(this, tr("Copy the values of the circular test"),
                              tr("Copy circularity and radial errors to the clipboard"), {}, [this] {
                                if (plot_->tests().empty()) {
                                  message_->setText(tr("There is no circular test yet: press Test first."));
                                  return;
                                }
                                QApplication::clipboard()->setText(
                                    circular_values(plot_->tests().front()).join(QLatin1Char('\n')));
                              }));
  actions_.append(make_action(this, tr("Save the picture of the circular test …"),
                              tr("The polar plot as PNG or SVG"), {}, [this] { save_picture(); }));
}

void CircularView::make_layout() {
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(4, 4, 4, 0);
  bar->addWidget(new QLabel(tr("Radius"), this));
  bar->addWidget(radius_);
  bar->addWidget(new QLabel(tr("Feed"), this));
  bar->addWidget(feed_);
  bar->addWidget(plane_);
  bar->addWidget(with_entry_);
  bar->addWidget(entry_);
  bar->addWidget(run_);
  bar->addStretch();
  message_->setContentsMargins(4, 0, 4, 0);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(bar);
  layout->addWidget(message_);
  layout->addWidget(plot_, 1);
}

CircularRequest CircularView::request() const {
  CircularRequest request;
  request.radius = from_shown_unit(radius_->value(), Dimension::length);
  request.feed = from_shown_unit(feed_->value(), Dimension::feed);
  request.plane = static_cast<CirclePlane>(plane_->currentIndex());
  request.sweep = 2 * std::numbers::pi;
  request.entry_radius = with_entry_->isChecked() ? from_shown_unit(entry_->value(), Dimension::length) : 0;
  return request;
}

void CircularView::run() {
  forget();
  run_->setText(tr("&Cancel"));
  message_->setText(tr("Simulating …"));
  job_.start([request = request(), setup = workbench_.setup().setup()](
                 JobControl& control) { return run_circular_test(request, setup, &control.progress); },
             [this](const JobOutcome<CircularTest>& outcome) {
               if (outcome.result) {
                 take(*outcome.result);
               } else {
                 show_idle(outcome.cancelled() ? tr("Cancelled.") : outcome.failure);
               }
             });
}

void CircularView::take(const CircularTest& test) {
  const Setup setup = workbench_.setup().setup();
  plot_->set_tests(
      tr("Circular test (ISO 230-4)"),
      tr("%1, model %2")
          .arg(QString::fromStdString(setup.machine.name), QString::fromStdString(setup.model->info().id)),
      {test});
  show_idle(test.actual
                ? tr("Actual path of the axes.")
                : tr("Set path: this machine has no drives. Give them in Machine and control, Drives."));
}

/// Another machine or control would have made another circle.
void CircularView::forget() {
  if (busy()) {
    job_.cancel();
  }
  plot_->set_tests({}, {}, {});
  show_idle({});
}

void CircularView::show_idle(const QString& message) {
  run_->setText(tr("Te&st"));
  message_->setText(message);
  message_->setVisible(!message.isEmpty());
}

QString CircularView::message() const {
  return message_->text();
}

void CircularView::save_picture() {
  if (plot_->tests().empty()) {
    show_idle(tr("There is no circular test yet: press Test first."));
    return;
  }
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Save the picture of the circular test"),
                                   QStringLiteral("circle.png"), tr("Pictures (*.png *.svg)"));
  if (file.isEmpty()) {
    return;
  }
  const QSize size = plot_->sizeHint();
  const auto draw = [this, size](QPainter& painter) {
    plot_->draw(painter, QRectF(QPointF(), QSizeF(size)));
  };
  try {
    if (file.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive)) {
      save_svg(file, size, tr("Circular test (ISO 230-4)"), draw);
    } else {
      save_png(file, size, 2, draw);
    }
  } catch (const InputError& error) {
    show_idle(QString::fromUtf8(error.what()));
  }
}

}  // namespace feedscope::ui
