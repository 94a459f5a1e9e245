#pragma once

#include <QAction>
#include <QActionGroup>
#include <QList>
#include <QObject>
#include <QToolBar>
#include <optional>

#include "ui/scene/scene_state.h"

class QMenu;
class QToolButton;

namespace feedscope::ui {

class NumberBox;

class SceneView;

/// The commands of a SceneView: its bar, its context menu, its keys.
class SceneActions : public QObject {
  Q_OBJECT

 public:
  explicit SceneActions(SceneView& view);

  QToolBar* bar() { return bar_; }
  QList<QAction*> all() const;
  /// Those that have keys.
  const QList<QAction*>& commands() const { return commands_; }
  /// Leaves on the bar what acts on this view alone: another one, which this is linked to, has the rest.
  void keep_own_on_bar();
  /// The context menu.
  void fill(QMenu& menu) const;
  /// The scene may have changed: checks, sizes and the bar's words say what it shows.
  void follow_scene();
  /// Whether there is another run to compare with; without one these colourings say what to do.
  void set_comparable(bool comparable);
  /// Whether the run shown has drives; without them the actual path and its colourings are not available.
  void set_drives(bool drives);
  void set_load(bool load);
  void enable(QuantitySource source, bool available, const QString& why_not);
  /// Which run that is, below the colourings.
  void add_comparison_menu(QMenu& menu);

 private:
  struct Choice {
    QActionGroup* group = nullptr;
    QMenu* menu = nullptr;
    QToolButton* button = nullptr;
  };

  Choice make_choice(const QString& tip);
  template <typename Slot>
  QAction* add_option(const Choice& choice, const QString& text, const QString& tip, const QVariant& value,
                      Slot slot);
  QAction* add_command(const QString& text, const QString& tip, const QKeySequence& key);
  void make_colourings();
  void group_colourings();
  QMenu* menu_of(Colouring colouring, QMenu& acceleration, QMenu& deviation, QMenu& load) const;
  void make_exaggerations();
  void make_views();
  void make_stretches();
  void make_tools();
  void make_modes();
  void apply_tool();
  void apply_stretch();
  void check(QActionGroup& group, const QVariant& value);

  SceneView& view_;
  QToolBar* bar_;
  Choice colouring_;
  Choice exaggeration_;
  Choice tool_;
  QActionGroup* stretch_ = nullptr;
  QAction* rest_hidden_ = nullptr;
  QMenu* differences_ = nullptr;  ///< colourings that compare two runs
  QMenu* views_ = nullptr;
  QList<QAction*> commands_;
  QAction* perspective_ = nullptr;
  QAction* axes_ = nullptr;
  QAction* all_rapids_ = nullptr;
  QAction* actual_ = nullptr;
  QAction* rapids_ = nullptr;
  QAction* machine_ = nullptr;
  std::optional<bool> drives_;  ///< whether the run shown has any, as the actions say
  std::optional<bool> load_;    ///< whether it has a cutting load
  QAction* measure_ = nullptr;
  QAction* box_ = nullptr;
  NumberBox* diameter_ = nullptr;
  NumberBox* corner_radius_ = nullptr;
  std::optional<SceneState> followed_;  ///< but for where the camera is
};

}  // namespace feedscope::ui
