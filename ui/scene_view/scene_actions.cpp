#include "ui/scene_view/scene_actions.h"

#include <QFormLayout>
#include <QLocale>
#include <QMenu>
#include <QToolButton>
#include <QWidgetAction>

#include "ui/fields/number_box.h"
#include "ui/language/shown_numbers.h"
#include "ui/scene_view/scene_texts.h"
#include "ui/scene_view/scene_view.h"
#include "ui/shared/panel_action.h"

namespace feedscope::ui {

namespace {

QString exaggeration_text(double factor) {
  return QStringLiteral("× %1").arg(QLocale().toString(factor, 'f', QLocale::FloatingPointShortest));
}

}  // namespace

SceneActions::SceneActions(SceneView& view) : QObject(&view), view_(view), bar_(new QToolBar(&view)) {
  bar_->setObjectName(QStringLiteral("scene_bar"));
  bar_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  make_colourings();
  make_exaggerations();
  make_views();
  make_tools();
  make_modes();
  follow_scene();
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

/// `slot` is called when the user chooses it.
template <typename Slot>
QAction* SceneActions::add_option(const Choice& choice, const QString& text, const QString& tip,
                                  const QVariant& value, Slot slot) {
  QAction* action = choice.menu->addAction(text);
  action->setCheckable(true);
  action->setToolTip(tip);
  action->setData(value);
  choice.group->addAction(action);
  connect(action, &QAction::triggered, this, slot);
  return action;
}

QAction* SceneActions::add_command(const QString& text, const QString& tip, const QKeySequence& key) {
  QAction* action = make_action(this, text, tip, key);
  // A single letter is a key of the 3D view only while it has the focus.
  const bool letter = key.count() == 1 && key[0].keyboardModifiers() == Qt::NoModifier;
  action->setShortcutContext(letter ? Qt::WidgetWithChildrenShortcut : Qt::WindowShortcut);
  view_.addAction(action);
  commands_.append(action);
  return action;
}

void SceneActions::make_colourings() {
  colouring_ = make_choice(tr("Quantity shown by the colour of the executed path"));
  const SceneTexts texts = scene_texts();
  for (const Colouring colouring : all_colourings()) {
    const QString title =
        colouring == Colouring::run ? tr("Run") : QString::fromStdString(colouring_title(colouring, texts));
    add_option(colouring_, title, tr("Colour the path by this quantity"), static_cast<int>(colouring),
               [this, colouring] { view_.scene().set_colouring(colouring); });
  }
  group_colourings();
  set_comparable(false);
}

/// Those that are alike in a menu of their own.
void SceneActions::group_colourings() {
  QMenu* acceleration = colouring_.menu->addMenu(tr("Acceleration and jerk"));
  QMenu* deviation = colouring_.menu->addMenu(tr("Deviation"));
  QMenu* load = colouring_.menu->addMenu(tr("Cutting load"));
  differences_ = colouring_.menu->addMenu(tr("Difference between runs"));
  for (QMenu* menu : {colouring_.menu, acceleration, deviation, load, differences_}) {
    menu->setToolTipsVisible(true);
  }
  for (QAction* option : colouring_.group->actions()) {
    const auto colouring = static_cast<Colouring>(option->data().toInt());
    QMenu* menu = menu_of(colouring, *acceleration, *deviation, *load);
    if (menu != nullptr) {
      colouring_.menu->removeAction(option);
      menu->addAction(option);
    }
  }
}

QMenu* SceneActions::menu_of(Colouring colouring, QMenu& acceleration, QMenu& deviation, QMenu& load) const {
  if (needs_reference(colouring)) {
    return differences_;
  }
  if (source_of(colouring) == QuantitySource::load) {
    return &load;
  }
  const QuantityInfo* quantity = quantity_of(colouring);
  if (quantity == nullptr) {
    return colouring == Colouring::contour_error ? &deviation : nullptr;
  }
  switch (quantity->dimension) {
    case Dimension::acceleration:
    case Dimension::jerk:
      return &acceleration;
    case Dimension::error:
      return &deviation;
    default:
      return nullptr;
  }
}

void SceneActions::set_drives(bool drives) {
  if (drives == drives_) {
    return;
  }
  drives_ = drives;
  actual_->setEnabled(drives);
  enable(QuantitySource::drives, drives, tr("The machine has no drives: give its axes kv_1_s"));
}

void SceneActions::set_load(bool load) {
  if (load != load_) {
    load_ = load;
    enable(QuantitySource::load, load, tr("Say how the tools are engaged in the panel Cutting load"));
  }
}

void SceneActions::enable(QuantitySource source, bool available, const QString& why_not) {
  for (QAction* option : colouring_.group->actions()) {
    if (source_of(static_cast<Colouring>(option->data().toInt())) == source) {
      option->setEnabled(available);
      option->setToolTip(available ? tr("Colour the path by this quantity") : why_not);
    }
  }
}

void SceneActions::set_comparable(bool comparable) {
  for (QAction* option : colouring_.group->actions()) {
    if (needs_reference(static_cast<Colouring>(option->data().toInt()))) {
      option->setEnabled(comparable);
      option->setToolTip(comparable ? tr("Colour the path by the difference from another run")
                                    : tr("There is no other run to compare with: duplicate the run (Ctrl+D) "
                                         "and change the copy"));
    }
  }
}

void SceneActions::add_comparison_menu(QMenu& menu) {
  differences_->addSeparator();
  differences_->addMenu(&menu);
}

void SceneActions::make_exaggerations() {
  exaggeration_ = make_choice(tr("Exaggeration of deviations from the programmed path"));
  for (const int factor : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
    add_option(exaggeration_, exaggeration_text(factor),
               tr("Exaggerate deviations from the programmed path by this factor"),
               static_cast<double>(factor), [this, factor] { view_.scene().set_exaggeration(factor); });
  }
}

void SceneActions::make_views() {
  auto* button = new QToolButton(bar_);
  button->setText(tr("View"));
  button->setToolTip(tr("Standard views, projection, axes"));
  button->setPopupMode(QToolButton::InstantPopup);
  views_ = new QMenu(button);
  button->setMenu(views_);
  bar_->addWidget(button);
  const auto add = [&](const QString& text, const QString& tip, const char* key, StandardView view) {
    QAction* action = add_command(text, tip, QKeySequence(QString::fromLatin1(key)));
    connect(action, &QAction::triggered, this, [this, view] { view_.scene().set_standard_view(view); });
    views_->addAction(action);
  };
  add(tr("&Isometric"), tr("View from the right, front and top"), "Ctrl+1", StandardView::iso);
  add(tr("&Top"), tr("View from above, X to the right"), "Ctrl+2", StandardView::top);
  add(tr("&Front"), tr("View from the front, X to the right"), "Ctrl+3", StandardView::front);
  add(tr("&Right"), tr("View from the right, Y to the right"), "Ctrl+4", StandardView::right);
  add(tr("&Bottom"), tr("View from below, X to the right"), "Ctrl+5", StandardView::bottom);
  add(tr("Bac&k"), tr("View from behind, X to the left"), "Ctrl+6", StandardView::back);
  add(tr("&Left"), tr("View from the left, Y to the left"), "Ctrl+7", StandardView::left);
  views_->addSeparator();
  perspective_ = add_command(tr("&Perspective"),
                             tr("Perspective: nearer parts look larger; without it lengths can be compared"),
                             QKeySequence(Qt::Key_P));
  perspective_->setCheckable(true);
  connect(perspective_, &QAction::triggered, this, [this](bool on) { view_.scene().set_perspective(on); });
  axes_ = add_command(tr("&Grid and axes"), tr("A box with grids around the path that shows its size"),
                      QKeySequence(Qt::Key_G));
  axes_->setCheckable(true);
  connect(axes_, &QAction::triggered, this, [this](bool on) { view_.scene().set_axes(on); });
  actual_ = add_command(tr("&Actual path"),
                        tr("The path that the axes run, drawn beside the one that the control sets"),
                        QKeySequence(Qt::Key_A));
  actual_->setCheckable(true);
  connect(actual_, &QAction::triggered, this, [this](bool on) { view_.scene().set_actual_shown(on); });
  rapids_ = add_command(tr("Rapi&ds"),
                        tr("Show rapids here and in the charts; without them the path that cuts lies open"),
                        QKeySequence(Qt::Key_R));
  rapids_->setCheckable(true);
  set_everyday_words(rapids_, tr("hide show G0"));
  connect(rapids_, &QAction::triggered, this, [this](bool on) { view_.scene().set_rapids_shown(on); });
  all_rapids_ = add_command(tr("Rapids that co&ver the picture"),
                            tr("Show rapids even where they cover more than 5 % of the picture"), {});
  all_rapids_->setCheckable(true);
  connect(all_rapids_, &QAction::triggered, this,
          [this](bool on) { view_.scene().set_all_rapids_shown(on); });
  machine_ =
      add_command(tr("Machine a&xes"),
                  tr("Draw the run where X, Y and Z of the machine stand while rotary axes turn, instead of "
                     "the tip on the part"),
                  QKeySequence(Qt::Key_X));
  machine_->setCheckable(true);
  set_everyday_words(machine_, tr("rotary five axis kinematics coordinates"));
  connect(machine_, &QAction::triggered, this, [this](bool on) { view_.scene().set_on_machine(on); });
  views_->addActions({perspective_, axes_});
  views_->addMenu(tr("&Shown"))->addActions({rapids_, all_rapids_, actual_, machine_});
  make_stretches();
}

/// Below the views: which stretch of the path is drawn in full.
void SceneActions::make_stretches() {
  QMenu* stretches = views_->addMenu(tr("&Drawn in full"));
  stretch_ = new QActionGroup(this);
  const auto add = [this, stretches](const QString& text, const QString& tip, const QKeySequence& key,
                                     PathStretch stretch) {
    QAction* action = add_command(text, tip, key);
    action->setCheckable(true);
    action->setData(static_cast<int>(stretch));
    stretch_->addAction(action);
    stretches->addAction(action);
    connect(action, &QAction::triggered, this, &SceneActions::apply_stretch);
    return action;
  };
  add(tr("&Whole path"), tr("Draw all of the path in full"), {}, PathStretch::whole);
  QAction* charts = add(tr("&Only the chart range"),
                        tr("Draw what the charts show in full, the rest of the path pale or not at all"),
                        QKeySequence(Qt::Key_O), PathStretch::charts);
  set_everyday_words(charts, tr("layer level clip transparent isolate"));
  QAction* trail =
      add(tr("&Up to the cursor"),
          tr("Draw what has been run up to the cursor in full, the rest of the path pale or not at all"),
          QKeySequence(Qt::Key_U), PathStretch::to_cursor);
  set_everyday_words(trail, tr("trail trace playback"));
  rest_hidden_ = add_command(
      tr("&Hide the rest"),
      tr("Hide the rest of the path, with all that lies outside of the box around what is drawn in full"),
      QKeySequence(Qt::Key_H));
  rest_hidden_->setCheckable(true);
  connect(rest_hidden_, &QAction::triggered, this, &SceneActions::apply_stretch);
  stretches->addAction(rest_hidden_);
}

void SceneActions::apply_stretch() {
  const QAction* chosen = stretch_->checkedAction();
  view_.scene().set_stretch(
      {chosen != nullptr ? static_cast<PathStretch>(chosen->data().toInt()) : PathStretch::whole,
       rest_hidden_->isChecked()});
}

void SceneActions::make_tools() {
  tool_ = make_choice(tr("Tool drawn at the cursor"));
  tool_.button->setText(tr("Tool"));
  const auto add = [&](const QString& text, const QString& tip, ToolKind kind) {
    add_option(tool_, text, tip, static_cast<int>(kind), [this] { apply_tool(); });
  };
  add(tr("Marker"), tr("A cone that marks the place, without dimensions"), ToolKind::marker);
  add(tr("Flat end mill"), tr("A cylinder"), ToolKind::flat);
  add(tr("Ball end mill"), tr("A cylinder with a hemispherical end"), ToolKind::ball);
  add(tr("Bull nose end mill"), tr("A cylinder with rounded corners"), ToolKind::bull);
  add(tr("No tool"), tr("Show nothing at the cursor"), ToolKind::none);
  const auto make_size = [this](double value, double most) {
    auto* size = new NumberBox;
    size->setRange(in_shown_unit(0.01, Dimension::length), in_shown_unit(most, Dimension::length));
    size->setDecimals(decimals_of(Dimension::length, 2));
    size->setValue(in_shown_unit(value, Dimension::length));
    size->setSuffix(' ' + unit_of(Dimension::length));
    connect(size, &NumberBox::valueChanged, this, &SceneActions::apply_tool);
    return size;
  };
  auto* sizes = new QWidget;
  auto* form = new QFormLayout(sizes);
  diameter_ = make_size(view_.scene().tool().diameter, 500);
  diameter_->setToolTip(tr("Diameter of the cutter"));
  corner_radius_ = make_size(view_.scene().tool().corner_radius, 250);
  corner_radius_->setToolTip(tr("Corner radius of a bull nose end mill"));
  form->addRow(tr("Diameter"), diameter_);
  form->addRow(tr("Corner radius"), corner_radius_);
  auto* action = new QWidgetAction(this);
  action->setDefaultWidget(sizes);
  tool_.menu->addSeparator();
  tool_.menu->addAction(action);
}

void SceneActions::apply_tool() {
  const QAction* chosen = tool_.group->checkedAction();
  if (chosen != nullptr) {
    view_.scene().set_tool({static_cast<ToolKind>(chosen->data().toInt()),
                            from_shown_unit(diameter_->value(), Dimension::length),
                            from_shown_unit(corner_radius_->value(), Dimension::length)});
  }
}

void SceneActions::make_modes() {
  bar_->addSeparator();
  measure_ = add_command(
      tr("&Measure"),
      tr("Click two points on the path to measure the distance, path length and time between them"),
      QKeySequence(Qt::Key_M));
  measure_->setCheckable(true);
  connect(measure_, &QAction::toggled, &view_, &SceneView::set_measuring);
  connect(&view_, &SceneView::measuring_changed, measure_, &QAction::setChecked);
  box_ = add_command(tr("&Box"), tr("Drag a box to zoom the view and the charts to it"),
                     QKeySequence(SceneView::tr("Ctrl+B")));
  box_->setCheckable(true);
  connect(box_, &QAction::toggled, &view_, &SceneView::set_boxing);
  connect(&view_, &SceneView::boxing_changed, box_, &QAction::setChecked);
  QAction* charts = add_command(tr("To &charts"), tr("Zoom the charts to the time range of the 3D view"),
                                QKeySequence(Qt::Key_C));
  connect(charts, &QAction::triggered, &view_, &SceneView::choose_visible_times);
  QAction* fit =
      add_command(tr("Fit &path"), tr("Fit the whole path into the view"), QKeySequence(tr("Ctrl+0")));
  connect(fit, &QAction::triggered, this, [this] { view_.scene().fit(); });
  bar_->addActions({measure_, box_, charts, fit});
}

void SceneActions::keep_own_on_bar() {
  for (QAction* action : bar_->actions()) {
    if (action != measure_ && action != box_) {
      bar_->removeAction(action);
    }
  }
}

void SceneActions::check(QActionGroup& group, const QVariant& value) {
  for (QAction* option : group.actions()) {
    if (option->data() == value) {
      option->setChecked(true);
      return;
    }
  }
  if (QAction* another = group.checkedAction()) {
    another->setChecked(false);
  }
}

void SceneActions::follow_scene() {
  machine_->setEnabled(view_.scene().knows_machine());
  set_drives(view_.scene().has(QuantitySource::drives));
  set_load(view_.scene().has(QuantitySource::load));
  SceneState shown = view_.state();
  shown.camera = {.perspective = shown.camera.perspective};
  if (shown == followed_) {
    return;
  }
  followed_ = shown;
  check(*colouring_.group, static_cast<int>(shown.colouring));
  colouring_.button->setText(tr("Colour: %1").arg(colouring_.group->checkedAction()->text()));
  check(*exaggeration_.group, shown.exaggeration);
  exaggeration_.button->setText(tr("Deviation %1").arg(exaggeration_text(shown.exaggeration)));
  check(*tool_.group, static_cast<int>(shown.tool.kind));
  for (const auto& [size, value] :
       {std::pair(diameter_, shown.tool.diameter), std::pair(corner_radius_, shown.tool.corner_radius)}) {
    const QSignalBlocker blocker(size);  // it is told, it does not tell
    size->setValue(value);
  }
  perspective_->setChecked(shown.camera.perspective);
  axes_->setChecked(shown.axes);
  actual_->setChecked(shown.actual);
  rapids_->setChecked(shown.rapids);
  all_rapids_->setChecked(shown.all_rapids);
  all_rapids_->setEnabled(shown.rapids);
  machine_->setChecked(shown.on_machine);
  check(*stretch_, static_cast<int>(shown.stretch.stretch));
  rest_hidden_->setChecked(shown.stretch.rest_hidden);
  rest_hidden_->setEnabled(shown.stretch.stretch != PathStretch::whole);
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
  QMenu* more = menu.addMenu(tr("&Zoom and measure"));
  const QList<QAction*> shown_on_bar = bar_->actions();
  for (QAction* command : commands_) {
    if (shown_on_bar.contains(command)) {
      more->addAction(command);
    }
  }
}

}  // namespace feedscope::ui
