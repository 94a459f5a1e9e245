#include "ui/paper/text_outline.h"

#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPath.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkVersionMacros.h>

#include <QFontMetricsF>
#include <QList>
#include <QPainter>
#include <algorithm>

#include "ui/theme/fonts.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
#include <vtkUnicodeString.h>
#endif

namespace feedscope::ui {

namespace {

constexpr int text_dots_per_inch = 72;  // as in Canvas

/// In outlines, VTK 9.1 treats each byte of a std::string as a letter, and has another string type for more
/// than ASCII; later versions have one type for all.
bool make_outline(vtkTextProperty& style, const QString& text, vtkPath& outline) {
  vtkTextRenderer& renderer = *vtkTextRenderer::GetInstance();
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  return renderer.StringToPath(&style, vtkUnicodeString::from_utf8(text.toStdString()), &outline,
                               text_dots_per_inch);
#pragma GCC diagnostic pop
#else
  return renderer.StringToPath(&style, text.toStdString(), &outline, text_dots_per_inch);
#endif
}

/// Whether VTK's font has all letters of the text.
bool has_letters(vtkTextProperty& style, const QString& text) {
  constexpr char32_t ascii = 128;
  const QList<uint> letters = text.toUcs4();
  return std::ranges::all_of(letters, [&](char32_t letter) {
    const vtkNew<vtkPath> outline;
    return letter < ascii || QChar::isSpace(letter) ||
           (make_outline(style, QString::fromUcs4(&letter, 1), *outline) && outline->GetNumberOfPoints() > 0);
  });
}

QPainterPath shape_of(vtkPath& outline, const QPointF& start) {
  const auto place = [&](vtkIdType i) {
    const double* at = outline.GetPoint(i);
    return start + QPointF(at[0], -at[1]);
  };
  QPainterPath path;
  path.setFillRule(Qt::WindingFill);
  vtkIntArray& codes = *outline.GetCodes();
  for (vtkIdType i = 0; i < codes.GetNumberOfTuples();) {
    switch (codes.GetValue(i)) {
      case vtkPath::MOVE_TO:
        path.moveTo(place(i));
        i += 1;
        break;
      case vtkPath::CONIC_CURVE:
        path.quadTo(place(i), place(i + 1));
        i += 2;
        break;
      case vtkPath::CUBIC_CURVE:
        path.cubicTo(place(i), place(i + 1), place(i + 2));
        i += 3;
        break;
      default:
        path.lineTo(place(i));
        i += 1;
    }
  }
  return path;
}

/// Offset of the letters from the origin, by the text's justification.
QPointF set_as(vtkTextProperty& style, const TextOutline& letters) {
  const QFontMetricsF metrics(letters.font);
  const int across = style.GetJustification();
  const int up = style.GetVerticalJustification();
  const double before = across == VTK_TEXT_LEFT ? 0 : across == VTK_TEXT_RIGHT ? 1 : 0.5;
  return {-before * metrics.horizontalAdvance(letters.text),
          up == VTK_TEXT_BOTTOM ? -metrics.descent()
          : up == VTK_TEXT_TOP  ? metrics.ascent()
                                : (metrics.ascent() - metrics.descent()) / 2};
}

}  // namespace

TextOutline text_outline(vtkTextActor& actor, int height) {
  vtkTextProperty& style = *actor.GetTextProperty();
  TextOutline made{
      {}, QString::fromUtf8(actor.GetInput()), paper_font(style.GetFontSize(), style.GetBold() != 0), {}};
  if (made.text.trimmed().isEmpty()) {
    return made;
  }
  const QPointF start(actor.GetPosition()[0], height - actor.GetPosition()[1]);
  const QTransform turned = QTransform::fromTranslate(start.x(), start.y()).rotate(-style.GetOrientation());
  if (!has_letters(style, made.text)) {
    const QPointF base = set_as(style, made);
    made.place = QTransform(turned).translate(base.x(), base.y());
    QPainterPath letters;
    letters.addText({}, made.font, made.text);
    letters.setFillRule(Qt::WindingFill);
    made.shape = made.place.map(letters);
    return made;
  }
  const vtkNew<vtkPath> outline;
  if (!make_outline(style, made.text, *outline)) {
    return made;
  }
  made.shape = shape_of(*outline, start);
  const QRectF ink = turned.inverted().map(made.shape).boundingRect();
  const QRectF letters = QFontMetricsF(made.font).tightBoundingRect(made.text);
  const double wider = letters.width() > 0 ? ink.width() / letters.width() : 1;
  made.place = QTransform(turned)
                   .translate(ink.left() - wider * letters.left(), ink.bottom() - letters.bottom())
                   .scale(wider, 1);
  return made;
}

void paint_letters(QPainter& painter, const TextOutline& outline) {
  painter.save();
  painter.setTransform(outline.place, true);
  painter.setFont(outline.font);
  painter.setPen(Qt::transparent);
  painter.drawText(QPointF(), outline.text);
  painter.restore();
}

}  // namespace feedscope::ui
