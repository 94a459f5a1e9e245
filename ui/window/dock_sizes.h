#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <QTimer>
#include <algorithm>
#include <array>

namespace feedscope::ui {

/// Keeps the panels around the middle of a window as large as the user has made them wherever the window is
/// large enough: a smaller one takes from them too, so that the middle stays usable, and gives it back when
/// it grows. QMainWindow alone takes all from the middle, and what it had to take from panels never comes
/// back. Until the user sizes them, what is right and below grows with the window. A window that is hardly
/// wide enough shows a strip of what is left.
class DockSizes : public QObject {
  Q_OBJECT

 public:
  /// Watches all panels that the window has now. `left`, `right`, `bottom`: what they have at first in a
  /// window that is large enough [logical pixels].
  DockSizes(QMainWindow& window, int left, int right, int bottom);

  /// Another layout has been restored: its sizes are those that the user has made.
  void follow_layout();
  /// The layout of the beginning is back: the sizes too.
  void follow_first_layout();
  /// While paused, the sizes of the panels are somebody else's, and nothing is noted.
  void set_paused(bool paused) { paused_ = paused; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Side {
    Qt::DockWidgetArea area;
    Qt::Orientation orientation;
    double usual_share;   ///< of the window's width or height, at most, unless the user wants more
    double narrow_share;  ///< the same of a window that is hardly wide enough for all
    int first;            ///< what it has at first [logical pixels]
    double growth = 0;    ///< share of what the window is larger than usual, until the user sizes it
    int wanted = first;   ///< as the user has it [logical pixels]
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
  /// The panel of a side that is in front; null without one.
  QDockWidget* shown_on(const Side& side) const;

  QMainWindow& window_;
  std::array<Side, 3> sides_;
  QTimer resized_;
  bool paused_ = false;
  bool begun_ = false;      ///< the window has been laid out
  bool restored_ = false;   ///< as the user once had it
  bool following_ = false;  ///< sizes are the window's doing, not the user's
};

}  // namespace feedscope::ui
