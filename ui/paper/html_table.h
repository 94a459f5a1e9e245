#pragma once

#include <QString>
#include <QStringList>
#include <vector>

class QAbstractItemModel;

namespace feedscope::ui {

/// `text` for HTML, with "<wbr>" where a long word may break.
QString html_text(const QString& text);
QString html_text(const std::string& text);
/// A paragraph that explains a table or picture; `text` is HTML.
QString caption_paragraph(const QString& text);
/// A paragraph of running text, which may contain HTML.
QString paragraph(const QString& text);

/// A table of a report, as HTML that browsers and QTextDocument lay out in the same way.
class HtmlTable {
 public:
  /// `sides`: 'l', 'r' or 'c' for each column. `widths`: in percent, 0 for a width by contents; may be empty.
  explicit HtmlTable(std::string sides, std::vector<int> widths = {});

  /// Cells are HTML. Heads are at the top and are repeated on each page.
  void add_head(const QStringList& cells);
  /// Adds a head over groups of columns: text and number of columns of each.
  void add_group_head(const std::vector<std::pair<QString, int>>& groups);
  /// `ground`: colour of the row, "#ffeedd".
  void add(const QStringList& cells, const QString& ground = {});
  bool empty() const { return rows_.isEmpty(); }
  QString html() const;

 private:
  QString cell(const char* tag, std::size_t column, const QString& text, int span = 1) const;

  std::string sides_;
  std::vector<int> widths_;
  QString heads_;
  QString rows_;
};

/// The cells of `model` as in a table view; the first row determines the alignment of columns. `widths`: as
/// of HtmlTable.
QString html_of_model(const QAbstractItemModel& model, std::vector<int> widths = {});

}  // namespace feedscope::ui
