#pragma once

#include <QAction>
#include <QList>
#include <QString>
#include <QWidget>

namespace feedscope::ui {

class Workbench;

/// A panel of the window. It follows the workbench itself and knows no other panel; the window docks it, adds
/// its commands to menus, and brings it to the front when it requests attention.
class Panel : public QWidget {
  Q_OBJECT

 public:
  /// Its initial dock.
  struct Place {
    QString id;     ///< name of its dock in layouts and sessions
    QString title;  ///< for people
    Qt::DockWidgetArea area;
    bool open = true;
  };

  Panel(Place place, QWidget* parent) : QWidget(parent), place_(std::move(place)) {}

  const Place& place() const { return place_; }
  /// Shows the contents of the workbench, now and after changes. To be called at most once; `workbench`
  /// outlives this. Panels constructed with a workbench follow it from the start.
  virtual void follow(Workbench& workbench);
  /// All commands of the panel, for menus, the list of keys and the command palette.
  virtual QList<QAction*> panel_actions() const { return {}; }
  /// Whether its contents are still being computed.
  virtual bool busy() const { return false; }
  /// Whether the panel is visible when shown: not while another one covers it.
  virtual void set_on_screen(bool /*on_screen*/) {}

 signals:
  /// A requested result appears here, and the panel may be hidden.
  void attention_wanted();
  /// `message` for the user.
  void failed(const QString& message);

 private:
  Place place_;
};

}  // namespace feedscope::ui
