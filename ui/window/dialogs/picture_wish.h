#pragma once

#include <QString>
#include <QStringList>

namespace feedscope::ui {

/// Options of a picture; keys and sizes in the words of `feedscope render`.
struct PictureWish {
  QString view = QStringLiteral("3d");        ///< 3d, charts, sheet, window
  QString format = QStringLiteral("png");     ///< png, svg, pdf
  QString size = QStringLiteral("1280x960");  ///< pixels, or a sheet such as A4-portrait
  int dpi = 300;                              ///< of sheets, and of bitmaps in SVG and PDF
  double scale = 1;                           ///< of text and lines
  QString theme;                              ///< light, dark; empty: the window's
  bool transparent = false;                   ///< without a background; not for the window
  QString language;                           ///< code; empty: English

  /// Whether the size is a sheet of paper.
  bool on_paper() const;
  /// Whether dots per inch apply.
  bool has_dpi() const { return on_paper() || format != QStringLiteral("png"); }
  bool operator==(const PictureWish&) const = default;
};

/// Arguments of `feedscope render` that draw a session file in this way, without --out.
QStringList picture_arguments(const PictureWish& wish, const QString& session);

/// The same picture for the screen: a bitmap, for paper with `dpi` pixels per inch.
PictureWish for_preview(PictureWish wish, int dpi);

}  // namespace feedscope::ui
