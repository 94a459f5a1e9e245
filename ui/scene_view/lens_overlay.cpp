#include "ui/scene_view/lens_overlay.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "ui/shared/panel_action.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {
namespace {

constexpr int side = 180;  // [pixels] at least, at the usual font size
constexpr int margin = 8;

}  // namespace

LensOverlay::LensOverlay(Workbench& workbench, SceneView& view)
    : QWidget(&view),
      workbench_(workbench),
      view_(view),
      action_(
          make_action(this, tr("&Lens at the cursor"),
                      tr("What the ticked runs do at the cursor, over each other, stretched across the path"),
                      QKeySequence(tr("L")))) {
  setToolTip(tr("The ticked runs at the cursor; click to enlarge"));
  setAccessibleName(tr("Lens at the cursor"));
  action_->setCheckable(true);
  connect(action_, &QAction::triggered, this, [this](bool on) {
    wanted_ = on;
    follow();
  });
  const RunList& runs = workbench_.runs();
  for (const auto signal : {&RunList::list_changed, &RunList::current_changed}) {
    connect(&runs, signal, this, &LensOverlay::follow);
  }
  for (const auto signal : {&RunList::item_changed, &RunList::result_changed}) {
    connect(&runs, signal, this, &LensOverlay::follow);
  }
  connect(&workbench_, &Workbench::run_changed, this, &LensOverlay::follow);
  connect(&workbench_.cursor(), &Cursor::changed, this, &LensOverlay::follow);
  view_.canvas().installEventFilter(this);
  follow();
}

int LensOverlay::usual_side() const {
  const QSize room = view_.canvas().size();
  constexpr double usual_share = 0.38;  // of the view's height
  const int wanted = std::max(type_pixels(side), static_cast<int>(usual_share * room.height()));
  return std::max(1, std::min({wanted, room.width() - 2 * margin, room.height() - 2 * margin}));
}

void LensOverlay::set_offered(bool offered) {
  offered_ = offered;
  follow();
}

void LensOverlay::list_runs() {
  runs_.clear();
  looks_.clear();
  const RunList& runs = workbench_.runs();
  const auto add = [&](std::size_t row) {
    const RunItem& item = runs.items()[row];
    const auto result = runs.result(row);
    if (result != nullptr && result->run.trajectory->path_length() > 0) {
      runs_.push_back(result);
      looks_.push_back({runs.lettered_title(row), item.colour, run_dashes(row)});
    }
  };
  add(runs.current());
  for (std::size_t row = 0; row < runs.items().size(); ++row) {
    if (row != runs.current() && runs.items()[row].visible) {
      add(row);
    }
  }
}

void LensOverlay::follow() {
  list_runs();
  const Cursor& cursor = workbench_.cursor();
  const bool current = workbench_.shown() != nullptr && !runs_.empty() && runs_.front() == workbench_.shown();
  const bool wanted = wanted_.value_or(offered_ && runs_.size() > 1 && has_room());
  const bool shown = wanted && current && cursor.valid();
  action_->setChecked(wanted);
  if (shown) {
    std::vector<const Run*> runs;
    for (const auto& run : runs_) {
      runs.push_back(&run->run);
    }
    lens_ = lens_at(runs, 0, cursor.state().time);
  }
  // A fit leaves the usual lens free; the large one is there for a look.
  view_.scene().set_inset(shown ? std::optional(usual_side() * view_.canvas().devicePixelRatioF())
                                : std::nullopt);
  place();
  raise();
  setVisible(shown);
  update();
}

/// Requires that most of the view remains for the path, also that of a presentation with its large type.
bool LensOverlay::has_room() const {
  constexpr double times_wide = 3.2;
  constexpr double times_high = 1.4;
  const int usual = type_pixels(side);
  return view_.canvas().width() >= times_wide * usual && view_.canvas().height() >= times_high * usual;
}

/// In the corner that the scene keeps free; a large one grows from there.
void LensOverlay::place() {
  const auto corners = view_.scene().inset();
  if (!corners) {
    return;
  }
  const QRect canvas = view_.canvas().geometry();
  const double ratio = view_.canvas().devicePixelRatioF();
  const auto [upper, lower] = *corners;
  QRect at((QPointF(upper[0], upper[1]) / ratio).toPoint() + canvas.topLeft(), QSize(1, 1) * usual_side());
  // All of it is in the view, also in a small one where there is no room above the legend.
  at.moveRight(std::min(at.right(), canvas.right() - margin));
  at.moveBottom(std::min(at.bottom(), canvas.bottom() - margin));
  at.moveTop(std::max(at.top(), canvas.top() + margin));
  if (large_) {
    const bool left = at.center().x() < canvas.center().x();
    const QPoint corner = left ? at.bottomLeft() : at.bottomRight();
    const int wanted = std::max(canvas.width(), canvas.height()) / 2;
    const int room = std::min(canvas.width() - 2 * margin, at.bottom() - canvas.top() - margin);
    at.setSize(QSize(1, 1) * std::max(at.width(), std::min(wanted, room)));
    left ? at.moveBottomLeft(corner) : at.moveBottomRight(corner);
  }
  setGeometry(at);
}

void LensOverlay::paintEvent(QPaintEvent*) {
  if (!lens_) {
    return;
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(palette().color(QPalette::Mid));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRoundedRect(frame, 4, 4);
  LensPicture(*lens_, looks_, static_cast<double>(type_pixels(side)) / side).paint(painter, frame, palette());
}

void LensOverlay::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    large_ = !large_;
    follow();
  }
}

bool LensOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Move) {
    follow();
  } else if (event->type() == QEvent::Paint && isVisible()) {  // a fit may have chosen the other corner
    QMetaObject::invokeMethod(this, &LensOverlay::place, Qt::QueuedConnection);
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace feedscope::ui
