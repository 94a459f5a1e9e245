#include "ui/paper/html_table.h"

#include <QAbstractItemModel>
#include <algorithm>
#include <utility>

namespace feedscope::ui {

namespace {

constexpr int longest_word = 18;  // in a column of a table; longer ones may be broken

QString broken(const QString& word) {
  if (word.size() <= longest_word) {
    return word.toHtmlEscaped();
  }
  QString text;
  int since = 0;
  for (qsizetype i = 0; i < word.size(); ++i) {
    text += QString(word[i]).toHtmlEscaped();
    ++since;
    const bool joint = since > 3 && QStringLiteral("/\\_-.,;:=").contains(word[i]);
    const bool pair = word[i].isHighSurrogate();
    if ((joint || since >= longest_word) && !pair && i + 1 < word.size()) {
      text += QStringLiteral("<wbr>");
      since = 0;
    }
  }
  return text;
}

}  // namespace

QString html_text(const QString& text) {
  QStringList words = text.split(' ');
  for (QString& word : words) {
    word = broken(word);
  }
  return words.join(' ');
}

QString html_text(const std::string& text) {
  return html_text(QString::fromStdString(text));
}

QString caption_paragraph(const QString& text) {
  return QStringLiteral("<p class=\"caption\">%1</p>\n").arg(text);
}

QString paragraph(const QString& text) {
  return QStringLiteral("<p>%1</p>\n").arg(text);
}

HtmlTable::HtmlTable(std::string sides, std::vector<int> widths)
    : sides_(std::move(sides)), widths_(std::move(widths)) {
  widths_.resize(sides_.size(), 0);
}

QString HtmlTable::cell(const char* tag, std::size_t column, const QString& text, int span) const {
  const char side = span > 1 ? 'c' : sides_[column];
  QString attributes = side == 'r'   ? QStringLiteral(" align=\"right\"")
                       : side == 'c' ? QStringLiteral(" align=\"center\"")
                                     : QStringLiteral(" align=\"left\"");
  if (span > 1) {
    attributes += QStringLiteral(" colspan=\"%1\"").arg(span);
  } else if (widths_[column] > 0) {
    attributes += QStringLiteral(" width=\"%1%\"").arg(widths_[column]);
  }
  return QStringLiteral("<%1%2>%3</%1>").arg(QLatin1String(tag), attributes, text);
}

void HtmlTable::add_head(const QStringList& cells) {
  heads_ += QStringLiteral("<tr>");
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    heads_ += cell("th", i, cells.value(static_cast<qsizetype>(i)));
  }
  heads_ += QStringLiteral("</tr>\n");
}

void HtmlTable::add_group_head(const std::vector<std::pair<QString, int>>& groups) {
  heads_ += QStringLiteral("<tr>");
  std::size_t column = 0;
  for (const auto& [text, span] : groups) {
    heads_ += cell("th", column, text, span);
    column += static_cast<std::size_t>(span);
  }
  heads_ += QStringLiteral("</tr>\n");
}

void HtmlTable::add(const QStringList& cells, const QString& ground) {
  rows_ += ground.isEmpty() ? QStringLiteral("<tr>") : QStringLiteral("<tr bgcolor=\"%1\">").arg(ground);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    rows_ += cell("td", i, cells.value(static_cast<qsizetype>(i)));
  }
  rows_ += QStringLiteral("</tr>\n");
}

QString HtmlTable::html() const {
  const QString head = heads_.isEmpty() ? QString() : QStringLiteral("<thead>\n%1</thead>\n").arg(heads_);
  return QStringLiteral(
             "<table class=\"data\" width=\"100%\" cellspacing=\"0\" cellpadding=\"3\">\n"
             "%1<tbody>\n%2</tbody>\n</table>\n")
      .arg(head, rows_);
}

QString html_of_model(const QAbstractItemModel& model, std::vector<int> widths) {
  std::string sides;
  QStringList heads;
  for (int column = 0; column < model.columnCount(); ++column) {
    const int aligned = model.index(0, column).data(Qt::TextAlignmentRole).toInt();
    sides += (aligned & Qt::AlignRight) != 0 ? 'r' : 'l';
    heads.append(html_text(model.headerData(column, Qt::Horizontal).toString().simplified()));
  }
  HtmlTable table(std::move(sides), std::move(widths));
  table.add_head(heads);
  for (int row = 0; row < model.rowCount(); ++row) {
    QStringList cells;
    for (int column = 0; column < model.columnCount(); ++column) {
      cells.append(html_text(model.index(row, column).data().toString()));
    }
    table.add(cells);
  }
  return table.html();
}

}  // namespace feedscope::ui
