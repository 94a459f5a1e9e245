#pragma once

#include <QObject>

class QWidget;

namespace feedscope::ui {

/// The font size of the program, as a factor on the usual one: panels, charts and captions of the 3D view
/// follow it, for a class that reads from the last row. Reports and files have their own sizes.
class TypeSize : public QObject {
  Q_OBJECT

 public:
  /// That of the QApplication, which must exist.
  static TypeSize& of_application();

  double scale() const { return scale_; }
  /// Sets the font size of all widgets now; `scale` is clamped to 0.5 to 8.
  void set_scale(double scale);

 signals:
  void changed();

 private:
  using QObject::QObject;

  double scale_ = 1;
};

/// Current size of something that has `usual` pixels at the usual font size.
int type_pixels(int usual);

/// Current width of a line that has `usual` pixels at the usual font size.
double line_pixels(double usual);
/// As above for drawings of `widget`: its lines also grow with a main window larger than 1920x1080, like its
/// pictures.
double line_pixels(double usual, const QWidget& widget);

/// Sets a widget's font to `usual` pixels at the usual font size, now and whenever the font size changes.
void set_type_pixels(QWidget& widget, int usual);

}  // namespace feedscope::ui
