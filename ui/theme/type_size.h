#pragma once

#include <QObject>

class QWidget;

namespace feedscope::ui {

/// The size of all type of the program, as one factor against the usual one: panels, charts and captions of
/// the 3D view follow it, as a class sees them from the last row. Reports and files have sizes of their own.
class TypeSize : public QObject {
  Q_OBJECT

 public:
  /// That of the QApplication, which must be there.
  static TypeSize& of_application();

  double scale() const { return scale_; }
  /// Type of all widgets, now; `scale` is brought between 0.5 and 8.
  void set_scale(double scale);

 signals:
  void changed();

 private:
  using QObject::QObject;

  double scale_ = 1;
};

/// What has `usual` pixels at the usual size of type, at the present one.
int type_pixels(int usual);

/// Width of a line that is usually `usual` pixels wide, at the present size of type.
double line_pixels(double usual);
/// The same of what `widget` draws: as large windows have larger pictures, lines grow with the main window,
/// too, where that is larger than 1920x1080.
double line_pixels(double usual, const QWidget& widget);

/// Gives a widget the type that usually has `usual` pixels, now and whenever the size of type changes.
void set_type_pixels(QWidget& widget, int usual);

}  // namespace feedscope::ui
