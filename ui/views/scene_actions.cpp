#include "ui/views/scene_actions.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLocale>
#include <QMenu>
#include <QToolButton>
#include <QWidgetAction>

#include "ui/views/scene_texts.h"
#include "ui/views/scene_view.h"

namespace feedscope::ui {

SceneActions::SceneActions(SceneView& view) : QObject(&view), view_(view), bar_(new QToolBar(&view)) {
  bar_->setObjectName(QStringLiteral("scene_bar"));
  bar_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  make_colourings();
  make_exaggerations();
  make_views();
  make_tools();
  make_modes();
}

SceneActions::Choice SceneActions::make_choice(const QString& tip) {
  Choice choice;
  choice.group = new QActionGroup(this);
  choice.menu = new QMenu(bar_);
  choice.button = new QToolButton(bar_);
  choice.button->setMenu(choice.menu);
  choice.button->setPopupMode(QToolButton::InstantPopup);
  choice.button->setToolTip(tip);
  bar_->addWidget(choice.button);
  return choice;
}

QAction* SceneActions::add_option(const Choice& choice, const QString& text, const QString& tip,
                                  bool checked) {
  QAction* action = choice.menu->addAction(text);
  action->setCheckable(true);
  action->setChecked(checked);
  action->setToolTip(tip);
  choice.group->addAction(action);
  return action;
}

QAction* SceneActions::add_command(const QString& text, const QString& tip, const QKeySequence& key) {
  auto* action = new QAction(text, this);
  action->setShortcut(key);
  // A single letter is a key of the 3D view only while it has the focus.
  const bool letter = key.count() == 1 && key[0].keyboardModifiers() == Qt::NoModifier;
  action->setShortcutContext(letter ? Qt::WidgetWithChildrenShortcut : Qt::WindowShortcut);
  action->setToolTip(
      key.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
  view_.addAction(action);
  commands_.append(action);
  return action;
}

void SceneActions::make_colourings() {
  colouring_ = make_choice(tr("What the colour of the executed path shows"));
  const SceneTexts texts = scene_texts();
  for (const Colouring colouring : all_colourings) {
    const QString title =
        colouring == Colouring::run ? tr("Run") : QString::fromStdString(colouring_title(colouring, texts));
    QAction* action =
        add_option(colouring_, title, tr("Colour the path by this"), colouring == view_.scene().colouring());
    connect(action, &QAction::toggled, this, [this, colouring, title](bool on) {
      if (on) {
        view_.scene().set_colouring(colouring);
        colouring_.button->setText(tr("Colour: %1").arg(title));
      }
    });
    if (action->isChecked()) {
      colouring_.button->setText(tr("Colour: %1").arg(title));
    }
  }
}

void SceneActions::make_exaggerations() {
  exaggeration_ =
      make_choice(tr("How much larger than they are deviations from the programmed path are drawn"));
  for (const int factor : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
    const QString text = QStringLiteral("× %1").arg(QLocale().toString(factor));
    QAction* action = add_option(exaggeration_, text,
                                 tr("Draw deviations from the programmed path so much larger"), factor == 1);
    connect(action, &QAction::toggled, this, [this, factor, text](bool on) {
      if (on) {
        view_.scene().set_exaggeration(factor);
        exaggeration_.button->setText(tr("Deviation %1").arg(text));
      }
    });
    if (factor == 1) {
      exaggeration_.button->setText(tr("Deviation %1").arg(text));
    }
  }
}

void SceneActions::make_views() {
  auto* button = new QToolButton(bar_);
  button->setText(tr("View"));
  button->setToolTip(tr("Standard views, projection, grid"));
  button->setPopupMode(QToolButton::InstantPopup);
  views_ = new QMenu(button);
  button->setMenu(views_);
  bar_->addWidget(button);
  const auto add = [&](const QString& text, const QString& tip, const char* key, StandardView view) {
    QAction* action = add_command(text, tip, QKeySequence(QString::fromLatin1(key)));
    connect(action, &QAction::triggered, this, [this, view] { view_.scene().set_standard_view(view); });
    views_->addAction(action);
  };
  add(tr("&Isometric"), tr("View from right, front and above"), "Ctrl+1", StandardView::iso);
  add(tr("&Top"), tr("View from above, X to the right"), "Ctrl+2", StandardView::top);
  add(tr("&Front"), tr("View from the front, X to the right"), "Ctrl+3", StandardView::front);
  add(tr("&Right"), tr("View from the right, Y to the right"), "Ctrl+4", StandardView::right);
  add(tr("&Bottom"), tr("View from below, X to the right"), "Ctrl+5", StandardView::bottom);
  add(tr("Bac&k"), tr("View from behind, X to the left"), "Ctrl+6", StandardView::back);
  add(tr("&Left"), tr("View from the left, Y to the left"), "Ctrl+7", StandardView::left);
  views_->addSeparator();
  QAction* perspective =
      add_command(tr("&Perspective"), tr("Nearer things look larger; without it lengths can be compared"),
                  QKeySequence(Qt::Key_P));
  perspective->setCheckable(true);
  connect(perspective, &QAction::toggled, this, [this](bool on) { view_.scene().set_perspective(on); });
  QAction* grid = add_command(tr("&Grid"), tr("Grid lines behind the path, in mm"), QKeySequence(Qt::Key_G));
  grid->setCheckable(true);
  grid->setChecked(view_.scene().grid());
  connect(grid, &QAction::toggled, this, [this](bool on) { view_.scene().set_grid(on); });
  views_->addActions({perspective, grid});
}

void SceneActions::make_tools() {
  tool_ = make_choice(tr("The tool drawn at the cursor"));
  tool_.button->setText(tr("Tool"));
  const auto add = [&](const QString& text, const QString& tip, ToolKind kind) {
    QAction* action = add_option(tool_, text, tip, kind == view_.scene().tool().kind);
    action->setData(static_cast<int>(kind));
    connect(action, &QAction::toggled, this, &SceneActions::apply_tool);
  };
  add(tr("Marker"), tr("A cone that marks the place, of no size"), ToolKind::marker);
  add(tr("Flat end mill"), tr("A cylinder"), ToolKind::flat);
  add(tr("Ball end mill"), tr("A cylinder with a half ball"), ToolKind::ball);
  add(tr("Bull nose end mill"), tr("A cylinder with rounded corners"), ToolKind::bull);
  add(tr("No tool"), tr("Nothing at the cursor"), ToolKind::none);
  const auto make_size = [this](double value, double most) {
    auto* size = new QDoubleSpinBox;
    size->setRange(0.01, most);
    size->setDecimals(2);
    size->setValue(value);
    size->setSuffix(tr(" mm"));
    connect(size, &QDoubleSpinBox::valueChanged, this, &SceneActions::apply_tool);
    return size;
  };
  auto* sizes = new QWidget;
  auto* form = new QFormLayout(sizes);
  diameter_ = make_size(view_.scene().tool().diameter, 500);
  diameter_->setToolTip(tr("Diameter of the cutter in mm"));
  corner_radius_ = make_size(view_.scene().tool().corner_radius, 250);
  corner_radius_->setToolTip(tr("Radius of a bull nose's corners in mm"));
  form->addRow(tr("Diameter"), diameter_);
  form->addRow(tr("Corner radius"), corner_radius_);
  auto* action = new QWidgetAction(this);
  action->setDefaultWidget(sizes);
  tool_.menu->addSeparator();
  tool_.menu->addAction(action);
}

void SceneActions::apply_tool() {
  const QAction* chosen = tool_.group->checkedAction();
  if (chosen != nullptr && diameter_ != nullptr && corner_radius_ != nullptr) {
    view_.scene().set_tool(
        {static_cast<ToolKind>(chosen->data().toInt()), diameter_->value(), corner_radius_->value()});
  }
}

void SceneActions::make_modes() {
  bar_->addSeparator();
  measure_ =
      add_command(tr("&Measure"), tr("Click two places on the path: distance, path length and time between"),
                  QKeySequence(Qt::Key_M));
  measure_->setCheckable(true);
  connect(measure_, &QAction::toggled, &view_, &SceneView::set_measuring);
  connect(&view_, &SceneView::measuring_changed, measure_, &QAction::setChecked);
  box_ = add_command(tr("&Box"), tr("Drag a box: the view and the charts show what is in it"),
                     QKeySequence(SceneView::tr("Ctrl+B")));
  box_->setCheckable(true);
  connect(box_, &QAction::toggled, &view_, &SceneView::set_boxing);
  connect(&view_, &SceneView::boxing_changed, box_, &QAction::setChecked);
  QAction* charts = add_command(tr("To &charts"), tr("The charts show the time range of what is in view"),
                                QKeySequence(Qt::Key_C));
  connect(charts, &QAction::triggered, &view_, &SceneView::choose_visible_times);
  QAction* fit = add_command(tr("Fit &path"), tr("The whole path in the view"), QKeySequence(tr("Ctrl+0")));
  connect(fit, &QAction::triggered, this, [this] { view_.scene().fit(); });
  bar_->addActions({measure_, box_, charts, fit});
}

QList<QAction*> SceneActions::all() const {
  return commands_ + colouring_.group->actions() + exaggeration_.group->actions() + tool_.group->actions();
}

void SceneActions::fill(QMenu& menu) const {
  const auto add = [&](QMenu* sub, const QString& title) {
    sub->setTitle(title);
    menu.addMenu(sub);
  };
  add(colouring_.menu, tr("Colour"));
  add(exaggeration_.menu, tr("Deviation"));
  add(views_, tr("View"));
  add(tool_.menu, tr("Tool"));
  menu.addSeparator();
  const QList<QAction*> shown_on_bar = bar_->actions();
  for (QAction* command : commands_) {
    if (shown_on_bar.contains(command)) {
      menu.addAction(command);
    }
  }
}

}  // namespace feedscope::ui
