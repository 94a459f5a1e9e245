#include "ui/theme/type_size.h"

#include <QApplication>
#include <QFont>
#include <QMainWindow>
#include <QSizeF>
#include <QWidget>
#include <algorithm>
#include <cmath>

namespace feedscope::ui {

namespace {

constexpr int usual_pixels = 12;  // 9 points at 96 dots per inch

}  // namespace

TypeSize& TypeSize::of_application() {
  auto* size = qApp->findChild<TypeSize*>(QString(), Qt::FindDirectChildrenOnly);
  return size != nullptr ? *size : *new TypeSize(qApp);
}

void TypeSize::set_scale(double scale) {
  constexpr double smallest = 0.5;
  constexpr double largest = 8;
  scale = std::clamp(scale, smallest, largest);
  if (scale == scale_) {
    return;
  }
  scale_ = scale;
  QFont font = QApplication::font();
  font.setPixelSize(type_pixels(usual_pixels));
  QApplication::setFont(font);
  emit changed();
}

int type_pixels(int usual) {
  return static_cast<int>(std::lround(usual * TypeSize::of_application().scale()));
}

double line_pixels(double usual) {
  return usual * TypeSize::of_application().scale();
}

double line_pixels(double usual, const QWidget& widget) {
  constexpr QSizeF reference(1920, 1080);
  constexpr double largest = 4;
  double of_window = 1;
  if (const auto* window = qobject_cast<const QMainWindow*>(widget.window())) {
    of_window = std::clamp(
        std::min(window->width() / reference.width(), window->height() / reference.height()), 1.0, largest);
  }
  return usual * std::max(of_window, TypeSize::of_application().scale());
}

void set_type_pixels(QWidget& widget, int usual) {
  const auto follow = [&widget, usual] {
    QFont font = widget.font();
    font.setPixelSize(type_pixels(usual));
    widget.setFont(font);
  };
  follow();
  QObject::connect(&TypeSize::of_application(), &TypeSize::changed, &widget, follow);
}

}  // namespace feedscope::ui
