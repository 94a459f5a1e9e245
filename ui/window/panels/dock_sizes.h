#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <QTimer>
#include <algorithm>
#include <array>

namespace feedscope::ui {

/// Keeps the user's sizes of the panels around the centre of a window, if the window is large enough. A
/// smaller window shrinks them too, so that the centre remains usable, and restores them when it grows.
/// QMainWindow alone shrinks the centre only, and never restores sizes that it had to take from panels. Until
/// the user resizes them, the right and lower panels grow with the window. In a window that is hardly wide
/// enough, the left panel is a narrow strip.
class DockSizes : public QObject {
  Q_OBJECT

 public:
  /// Watches all panels of the window at this time. `left`, `right`, `bottom`: initial sizes in a window that
  /// is large enough [logical pixels].
  DockSizes(QMainWindow& window, int left, int right, int bottom);

  /// Another layout has been restored: its sizes are the user's.
  void follow_layout();
  /// The initial layout has been restored, with its sizes.
  void follow_first_layout();
  /// While paused, sizes of panels are set elsewhere and not recorded.
  void set_paused(bool paused) { paused_ = paused; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Side {
    Qt::DockWidgetArea area;
    Qt::Orientation orientation;
    double usual_share;   ///< of the window's width or height, maximum unless the user chooses more
    double narrow_share;  ///< as above, in a window that is hardly wide enough for all
    int first;            ///< initial size [logical pixels]
    double growth = 0;    ///< share of the window's additional size, until the user resizes it
    int wanted = first;   ///< user's size [logical pixels]
    bool sized = false;   ///< by the user
    double largest_share = usual_share;

    int extent(const QWidget& widget) const {
      return orientation == Qt::Horizontal ? widget.width() : widget.height();
    }
    int aim(const QWidget& window) const {
      constexpr QSize usual(1280, 800);
      const int more = extent(window) - (orientation == Qt::Horizontal ? usual.width() : usual.height());
      return wanted + (sized ? 0 : static_cast<int>(growth * std::max(0, more)));
    }
    int most(const QWidget& window) const {
      constexpr int narrow = 1100;  // [logical pixels]
      const double share = window.width() < narrow ? narrow_share : largest_share;
      return static_cast<int>(share * extent(window));
    }
  };

  void note(QDockWidget& dock);
  void adopt(Side& side, const QDockWidget& dock) const;
  int tab_height(const QDockWidget& dock) const;
  void begin();
  void apply();
  /// The front panel of a side; null without one.
  QDockWidget* shown_on(const Side& side) const;

  QMainWindow& window_;
  std::array<Side, 3> sides_;
  QTimer resized_;
  bool paused_ = false;
  bool begun_ = false;      ///< whether the window has been laid out
  bool restored_ = false;   ///< whether a user's layout was restored
  bool following_ = false;  ///< whether sizes change by the window, not the user
};

}  // namespace feedscope::ui
