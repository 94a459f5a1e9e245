#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <string>
#include <vector>

namespace feedscope::ui {

/// A page with placeholders in double braces, "{{comparison_table}}", which are replaced by blocks of a
/// report. Text between "{{#notes}}" and "{{/notes}}" is omitted if the block is empty; text between
/// "{{?charts}}" and
/// "{{/charts}}", unless that section is requested by its name, which is any word. "{{!" begins a remark.
/// {{"Places of %1" run}} is a text in the current language, with blocks for %1, %2 and so on; a text without
/// a translation remains as it is.
class ReportTemplate {
 public:
  /// `name`: of the template in messages. Throws InputError with name, line and the nearest known
  /// placeholder: a placeholder not in `known`, braces, quotes or a section not closed.
  ReportTemplate(QString text, QString name, const QStringList& known);

  /// The page with blocks for placeholders; each block is requested once. `with`: requested sections, "all"
  /// for all of them.
  QString filled(const std::function<QString(const QString&)>& block, const QStringList& with = {}) const;
  /// The placeholders of the page with these sections, without repetition, in order.
  QStringList placeholders(const QStringList& with = {QStringLiteral("all")}) const;
  /// The sections that can be requested, in order.
  QStringList sections() const;

 private:
  enum class Kind { text, words, block, begin, begin_asked, end };
  struct Part {
    Kind kind = Kind::text;
    QString text;             ///< text as it is, text to translate, or a placeholder's name
    QStringList blocks = {};  ///< names for %1, %2, ...
  };

  struct Open {
    QString name;       ///< of the section that begins
    std::string place;  ///< file and line
  };

  void add(const QString& word, const std::string& place, const QStringList& known, std::vector<Open>& open);

  void add_words(const QString& word, const std::string& place, const QStringList& known);

  std::vector<Part> parts_;
};

/// The shipped template, or the one in `file`. Throws InputError if it is unreadable, or larger than any
/// template.
QString read_template(const QString& file);
/// Name of the shipped template's file.
QString shipped_template();

}  // namespace feedscope::ui
