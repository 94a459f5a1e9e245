#include "ui/theme/bundled_fonts.h"

#include <QApplication>
#include <QFont>
#include <QFontDatabase>
#include <QRawFont>
#include <array>

namespace feedscope::ui {
namespace {

struct Face {
  const char* family;
  const char* style;
  const char* file;
};

constexpr std::array faces{Face{"DejaVu Sans", "Book", "DejaVuSans.ttf"},
                           Face{"DejaVu Sans", "Bold", "DejaVuSans-Bold.ttf"},
                           Face{"DejaVu Sans", "Oblique", "DejaVuSans-Oblique.ttf"},
                           Face{"DejaVu Sans Mono", "Book", "DejaVuSansMono.ttf"},
                           Face{"DejaVu Sans Mono", "Bold", "DejaVuSansMono-Bold.ttf"}};

/// Whether a font has no letters: Qt also lists generic families without an installed font.
bool draws_boxes(const QFont& font) {
  const QRawFont raw = QRawFont::fromFont(font);
  return !raw.isValid() || !raw.supportsCharacter(QLatin1Char('A'));
}

void add_once() {
  const bool none = draws_boxes(QApplication::font());
  for (const Face& face : faces) {
    const QString family = QString::fromLatin1(face.family);
    if (!QFontDatabase::styles(family).contains(QString::fromLatin1(face.style))) {
      QFontDatabase::addApplicationFont(QStringLiteral(":/fonts/") + QString::fromLatin1(face.file));
    }
  }
  if (none) {
    QFont font = QApplication::font();
    font.setFamily(QString::fromLatin1(faces.front().family));
    QApplication::setFont(font);
  }
}

}  // namespace

void add_missing_fonts() {
  [[maybe_unused]] static const bool added = (add_once(), true);
}

}  // namespace feedscope::ui
