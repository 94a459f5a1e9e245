#pragma once

#include <QAction>
#include <QList>
#include <QString>
#include <QWidget>

namespace feedscope::ui {

class Workbench;

/// A panel of the window. It follows the workbench by itself and knows no other panel; the window docks it,
/// puts its commands into menus, and brings it to the front when it asks for attention.
class Panel : public QWidget {
  Q_OBJECT

 public:
  /// How it is docked at first.
  struct Place {
    QString id;     ///< name of its dock in layouts and sessions
    QString title;  ///< for people
    Qt::DockWidgetArea area;
    bool open = true;
  };

  Panel(Place place, QWidget* parent) : QWidget(parent), place_(std::move(place)) {}

  const Place& place() const { return place_; }
  /// Shows what the workbench holds, now and from now on. To be called once, if at all; `workbench` outlives
  /// this. Panels that are made on a workbench follow it from the start.
  virtual void follow(Workbench& workbench);
  /// Every command of the panel, for menus, the list of keys and the command palette.
  virtual QList<QAction*> panel_actions() const { return {}; }
  /// Whether it still works at what it shows.
  virtual bool busy() const { return false; }
  /// Whether it can be seen when it is shown: not while another panel lies on top of it.
  virtual void set_on_screen(bool /*on_screen*/) {}

 signals:
  /// What was asked for is shown here, and the panel may be hidden.
  void attention_wanted();
  /// `message` for the user.
  void failed(const QString& message);

 private:
  Place place_;
};

}  // namespace feedscope::ui
