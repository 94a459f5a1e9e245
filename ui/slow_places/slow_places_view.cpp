#include "ui/slow_places/slow_places_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTreeView>
#include <QVBoxLayout>
#include <limits>
#include <utility>

#include "ui/fields/focus_outline.h"
#include "ui/language/texts.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/row_copy.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

SlowPlacesView::SlowPlacesView(QWidget* parent)
    : Panel({QStringLiteral("slow-places"), tr("Slow places"), Qt::BottomDockWidgetArea, false}, parent),
      model_(new SlowPlacesModel(this)),
      list_(new QTreeView(this)),
      most_(new QComboBox(this)),
      sum_(new QLabel(this)) {
  for (const int count : {10, 100, 1000}) {
    most_->addItem(tr("Worst %1").arg(QLocale().toString(count)), count);
  }
  most_->addItem(tr("All"), std::numeric_limits<int>::max());
  most_->setCurrentIndex(most_->findData(static_cast<int>(SlowPlacesModel::default_most)));
  most_->setToolTip(tr("Number of places listed and visited by F7"));
  most_->setAccessibleName(tr("Number of places"));
  connect(most_, &QComboBox::currentIndexChanged, this, [this] {
    model_->set_most(static_cast<std::size_t>(most_->currentData().toInt()));
    say_sum();
  });
  sum_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  sum_->setWordWrap(true);

  list_->setModel(model_);
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setAccessibleName(tr("Slow places"));
  list_->header()->setStretchLastSection(true);
  install_row_copy(*list_);
  new FocusOutline(*list_);
  connect(list_, &QTreeView::clicked, this, &SlowPlacesView::choose);
  connect(list_, &QTreeView::activated, this, &SlowPlacesView::choose);

  add_step(tr("Next slow place"), tr("Go to the next listed place that loses time"), QKeySequence(Qt::Key_F7),
           true);
  add_step(tr("Previous slow place"), tr("Go to the previous listed place"),
           QKeySequence(Qt::SHIFT | Qt::Key_F7), false);

  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(4, 4, 4, 4);
  bar->setSpacing(8);
  bar->addWidget(most_);
  bar->addWidget(sum_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(bar);
  layout->addWidget(list_, 1);
}

void SlowPlacesView::add_step(const QString& text, const QString& tip, const QKeySequence& key,
                              bool forward) {
  QAction* action = make_action(this, text, tip, key, [this, forward] { step(forward); });
  addAction(action);
  actions_.append(action);
}

void SlowPlacesView::follow(Workbench& workbench) {
  const auto show_run = [this, &workbench] {
    const auto shown = workbench.shown();
    set_places(shown == nullptr ? nullptr : shown->slow_places);
  };
  const auto show_cursor = [this, &cursor = workbench.cursor()] {
    set_time(cursor.valid() ? cursor.state().time : 0);
  };
  connect(&workbench, &Workbench::run_changed, this, show_run);
  connect(&workbench.cursor(), &Cursor::changed, this, show_cursor);
  connect(this, &SlowPlacesView::place_chosen, &workbench, &Workbench::show_place);
  show_run();
  show_cursor();
}

void SlowPlacesView::set_places(std::shared_ptr<const SlowPlaces> places) {
  model_->set_places(std::move(places));
  for (int column = 0; column < SlowPlacesModel::cause; ++column) {
    list_->resizeColumnToContents(column);
  }
  say_sum();
}

QString SlowPlacesView::summary() const {
  return sum_->text();
}

void SlowPlacesView::say_sum() {
  const SlowPlaces* places = model_->places();
  if (places == nullptr) {
    sum_->clear();
    return;
  }
  sum_->setText(tr("%1 of %2 lost against the programmed feed, in %3 places")
                    .arg(clock_text(model_->listed_loss()), clock_text(places->loss),
                         QLocale().toString(static_cast<qulonglong>(places->count))));
  sum_->setToolTip(sum_->text());
}

void SlowPlacesView::step(bool forward) {
  const int row = model_->next_row(time_, forward);
  if (row >= 0) {
    const QModelIndex index = model_->index(row, 0);
    list_->setCurrentIndex(index);
    choose(index);
  }
}

void SlowPlacesView::choose(const QModelIndex& index) {
  const SlowPlace& place = model_->place(index.row());
  time_ = place.slowest;
  emit place_chosen(place.slowest, place.from, place.to);
}

}  // namespace feedscope::ui
