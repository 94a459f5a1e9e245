#include "ui/views/theme.h"

#include <QApplication>
#include <QFont>
#include <QPalette>
#include <QStyleFactory>

namespace feedscope::ui {

void apply_theme() {
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QPalette palette;
  palette.setColor(QPalette::Window, QColor(0xf4, 0xf5, 0xf7));
  palette.setColor(QPalette::WindowText, QColor(0x22, 0x26, 0x2a));
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::AlternateBase, QColor(0xf7, 0xf8, 0xfa));
  palette.setColor(QPalette::Text, QColor(0x22, 0x26, 0x2a));
  palette.setColor(QPalette::PlaceholderText, QColor(0x77, 0x7d, 0x84));
  palette.setColor(QPalette::Button, QColor(0xec, 0xee, 0xf1));
  palette.setColor(QPalette::ButtonText, QColor(0x22, 0x26, 0x2a));
  palette.setColor(QPalette::Highlight, QColor(0x2f, 0x6f, 0xb0));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, QColor(0xff, 0xff, 0xf2));
  palette.setColor(QPalette::ToolTipText, QColor(0x22, 0x26, 0x2a));
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, QColor(0x9a, 0xa0, 0xa6));
  }
  QApplication::setPalette(palette);
  QFont font = QApplication::font();
  font.setPixelSize(12);
  QApplication::setFont(font);
}

}  // namespace feedscope::ui
