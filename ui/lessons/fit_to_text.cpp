#include "ui/lessons/fit_to_text.h"

#include <QAbstractTextDocumentLayout>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "ui/theme/type_size.h"

namespace feedscope::ui {

void fit_to_text(QTextBrowser& browser) {
  browser.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const auto fit = [&browser](const QSizeF& text) {
    browser.setFixedHeight(static_cast<int>(std::ceil(text.height())) + 2 * browser.frameWidth());
  };
  QObject::connect(browser.document()->documentLayout(), &QAbstractTextDocumentLayout::documentSizeChanged,
                   &browser, fit);
  fit(browser.document()->size());
}

void fit_to_lines(QPlainTextEdit& field) {
  field.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const auto fit = [&field] {
    constexpr int fewest = 3;
    double height = 0;  // lines with letters of another font are higher
    for (QTextBlock block = field.document()->begin(); block.isValid(); block = block.next()) {
      height += field.document()->documentLayout()->blockBoundingRect(block).height();
    }
    const double margins = 2 * (field.frameWidth() + field.document()->documentMargin());
    field.setFixedHeight(static_cast<int>(
        std::ceil(std::max<double>(height, fewest * field.fontMetrics().lineSpacing()) + margins)));
  };
  QObject::connect(field.document()->documentLayout(), &QAbstractTextDocumentLayout::documentSizeChanged,
                   &field, fit);
  // Narrower or wider, the text has more or fewer lines.
  QObject::connect(field.verticalScrollBar(), &QScrollBar::rangeChanged, &field, fit);
  QObject::connect(&TypeSize::of_application(), &TypeSize::changed, &field,
                   [&field, fit] { QTimer::singleShot(0, &field, fit); });
  fit();
}

}  // namespace feedscope::ui
