#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <string>
#include <vector>

namespace feedscope::ui {

/// A page with placeholders in double braces, "{{comparison_table}}", which become blocks of a report. What
/// stands between "{{#notes}}" and "{{/notes}}" is omitted where the block is empty; between "{{?charts}}"
/// and
/// "{{/charts}}", unless that section is asked for by its name, which is any word. "{{!" begins a remark.
/// {{"Places of %1" run}} is a text in the language in force, with blocks for %1, %2 and so on; a text that
/// has no translation stays as it is.
class ReportTemplate {
 public:
  /// `name` is what messages call the template. Throws InputError with name, line and the nearest known
  /// placeholder: a placeholder not in `known`, braces, quotes or a section not closed.
  ReportTemplate(QString text, QString name, const QStringList& known);

  /// The page with blocks for placeholders; each block is asked for once. `with`: sections that are asked
  /// for, "all" for every one.
  QString filled(const std::function<QString(const QString&)>& block, const QStringList& with = {}) const;
  /// The placeholders that occur there, without repetition, in their order.
  QStringList placeholders(const QStringList& with = {QStringLiteral("all")}) const;
  /// The sections that may be asked for, in their order.
  QStringList sections() const;

 private:
  enum class Kind { text, words, block, begin, begin_asked, end };
  struct Part {
    Kind kind = Kind::text;
    QString text;             ///< as it is, to be translated, or the placeholder's name
    QStringList blocks = {};  ///< names of those in the places of words
  };

  struct Open {
    QString name;       ///< of a section that has begun
    std::string place;  ///< file and line
  };

  void add(const QString& word, const std::string& place, const QStringList& known, std::vector<Open>& open);

  void add_words(const QString& word, const std::string& place, const QStringList& known);

  std::vector<Part> parts_;
};

/// The template that is shipped, or the one in `file`. Throws InputError where it cannot be read, or is
/// larger than any template.
QString read_template(const QString& file);
/// Where the shipped one lies.
QString shipped_template();

}  // namespace feedscope::ui
