#include "ui/report/report_template.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <QFile>
#include <QHash>
#include <algorithm>
#include <array>

#include "core/base/data_folder.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "ui/report/report_words.h"

namespace feedscope::ui {

namespace {

constexpr qint64 largest_template = 16 << 20;  // [bytes]; pictures may be embedded

qsizetype line_of(const QString& text, qsizetype place) {
  return text.left(place).count('\n') + 1;
}

std::vector<std::string> as_std(const QStringList& names) {
  std::vector<std::string> list;
  for (const QString& name : names) {
    list.push_back(name.toStdString());
  }
  return list;
}

/// Notation in a template.
std::string braced(const QString& name, const char* sign = "") {
  return "'{{" + (sign + name.toStdString()) + "}}'";
}

[[noreturn]] void refuse_unknown(const std::string& place, const QString& name, const QStringList& known) {
  const std::vector<std::string> names = as_std(known);
  const std::string near = nearest_name(name.toStdString(), names);
  const Message known_ones =
      near.empty() ? message(NC_("core", "known: {}"), fmt::to_string(fmt::join(names, ", ")))
                   : message(NC_("core", "did you mean {}?"), braced(QString::fromStdString(near)));
  throw InputError(
      at_place(place, message(NC_("core", "unknown placeholder {}; {}"), braced(name), known_ones)));
}

/// Translatable texts: those of the shipped template.
constexpr auto translated = std::to_array<const char*>({
    QT_TRANSLATE_NOOP("ReportWords", "%1 on %2"),
    QT_TRANSLATE_NOOP("ReportWords", "Where %1 loses most"),
    QT_TRANSLATE_NOOP("ReportWords", "Motion"),
    QT_TRANSLATE_NOOP("ReportWords", "Machine, settings, models, trust"),
    QT_TRANSLATE_NOOP("ReportWords", "Figures of the runs"),
    QT_TRANSLATE_NOOP("ReportWords", "Notes"),
    QT_TRANSLATE_NOOP("ReportWords", "Where does the time go?"),
    QT_TRANSLATE_NOOP("ReportWords", "Places that lose most, by what they have in common"),
    QT_TRANSLATE_NOOP("ReportWords", "What would help"),
    QT_TRANSLATE_NOOP("ReportWords", "Cycle time and what limits it"),
    QT_TRANSLATE_NOOP("ReportWords", "Settings that differ"),
    QT_TRANSLATE_NOOP("ReportWords", "Axes against their limits"),
    QT_TRANSLATE_NOOP("ReportWords", "Along the path"),
    QT_TRANSLATE_NOOP("ReportWords", "Where most time is lost"),
    QT_TRANSLATE_NOOP("ReportWords", "Places of %1 that are slower than programmed, the worst first."),
    QT_TRANSLATE_NOOP("ReportWords", "Where the path deviates most"),
    QT_TRANSLATE_NOOP("ReportWords",
                      "Places of %1 that are farthest from the programmed path, the worst first; left and "
                      "right are seen in its direction."),
    QT_TRANSLATE_NOOP("ReportWords", "Agreement with the control"),
    QT_TRANSLATE_NOOP(
        "ReportWords",
        "What the control recorded, beside %1; the feeds of both stand in the charts along the path."),
    QT_TRANSLATE_NOOP("ReportWords", "Identification"),
    QT_TRANSLATE_NOOP("ReportWords", "Limits and settings of the machine, found from what it recorded."),
    QT_TRANSLATE_NOOP("ReportWords", "Circular test"),
    QT_TRANSLATE_NOOP("ReportWords", "Full circles of the program as %1 makes them, evaluated by ISO 230-4."),
    QT_TRANSLATE_NOOP("ReportWords", "Cutting load"),
    QT_TRANSLATE_NOOP("ReportWords", "What %1 puts on the tools, beside what the programmed feed would."),
    QT_TRANSLATE_NOOP("ReportWords", "Program"),
    QT_TRANSLATE_NOOP("ReportWords", "Messages of the reader"),
    QT_TRANSLATE_NOOP("ReportWords", "Machine"),
    QT_TRANSLATE_NOOP(
        "ReportWords",
        "Every number with its source; values that no source gives are assumed and in italics."),
    QT_TRANSLATE_NOOP("ReportWords", "Settings of the runs"),
    QT_TRANSLATE_NOOP("ReportWords", "Control models"),
    QT_TRANSLATE_NOOP("ReportWords", "How to make this again"),
    QT_TRANSLATE_NOOP("ReportWords", "With Feedscope %1:"),
});

QString word_of_template(const QString& text) {
  const auto found =
      std::ranges::find(translated, text, [](const char* known) { return QString::fromUtf8(known); });
  return found == translated.end() ? text : ReportWords::tr(*found);
}

/// Replaces %1, %2 and so on by blocks.
QString with_blocks(const QString& text, const QStringList& blocks) {
  QString made;
  for (qsizetype i = 0; i < text.size(); ++i) {
    const int number = text[i] == '%' && i + 1 < text.size() ? text[i + 1].digitValue() : 0;
    if (number >= 1 && number <= blocks.size()) {
      made += blocks[number - 1];
      ++i;
    } else {
      made += text[i];
    }
  }
  return made;
}

}  // namespace

ReportTemplate::ReportTemplate(QString text, QString name, const QStringList& known) {
  std::vector<Open> open;
  qsizetype at = 0;
  for (qsizetype begin = text.indexOf(QStringLiteral("{{")); begin >= 0;
       begin = text.indexOf(QStringLiteral("{{"), at)) {
    parts_.push_back({Kind::text, text.mid(at, begin - at)});
    const std::string place = fmt::format("{}:{}", name.toStdString(), line_of(text, begin));
    const qsizetype end = text.indexOf(QStringLiteral("}}"), begin);
    if (end < 0) {
      throw InputError(at_place(place, NC_("core", "'{{' without '}}'")));
    }
    at = end + 2;
    add(text.mid(begin + 2, end - begin - 2).trimmed(), place, known, open);
  }
  parts_.push_back({Kind::text, text.mid(at)});
  if (!open.empty()) {
    throw InputError(
        at_place(open.back().place, message(NC_("core", "section {} is not closed; write {} after it"),
                                            braced(open.back().name, "#"), braced(open.back().name, "/"))));
  }
}

void ReportTemplate::add(const QString& word, const std::string& place, const QStringList& known,
                         std::vector<Open>& open) {
  if (word.startsWith('!')) {
    return;
  }
  if (word.startsWith('"')) {
    add_words(word, place, known);
    return;
  }
  const Kind kind = word.startsWith('#')   ? Kind::begin
                    : word.startsWith('?') ? Kind::begin_asked
                    : word.startsWith('/') ? Kind::end
                                           : Kind::block;
  const QString name = kind == Kind::block ? word : word.mid(1).trimmed();
  const bool of_section = std::ranges::any_of(open, [&](const Open& one) { return one.name == name; });
  if (kind != Kind::begin_asked && !(kind == Kind::end && of_section) && !known.contains(name)) {
    refuse_unknown(place, name, known);
  }
  if (kind == Kind::begin || kind == Kind::begin_asked) {
    open.push_back({name, place});
  } else if (kind == Kind::end) {
    if (open.empty() || open.back().name != name) {
      throw InputError(at_place(place, open.empty()
                                           ? message(NC_("core", "{} closes no section"), braced(name, "/"))
                                           : message(NC_("core", "{} closes no section; {} is open"),
                                                     braced(name, "/"), braced(open.back().name, "#"))));
    }
    open.pop_back();
  }
  parts_.push_back({kind, name});
}

void ReportTemplate::add_words(const QString& word, const std::string& place, const QStringList& known) {
  const qsizetype end = word.lastIndexOf('"');
  if (end == 0) {
    throw InputError(
        at_place(place, message(NC_("core", "the text {} has no quote at its end"), word.toStdString())));
  }
  const QStringList blocks = word.mid(end + 1).split(' ', Qt::SkipEmptyParts);
  for (const QString& name : blocks) {
    if (!known.contains(name)) {
      refuse_unknown(place, name, known);
    }
  }
  parts_.push_back({Kind::words, word.mid(1, end - 1), blocks});
}

namespace {

bool is_asked(const QStringList& with, const QString& section) {
  return with.contains(section) || with.contains(QStringLiteral("all"));
}

}  // namespace

QString ReportTemplate::filled(const std::function<QString(const QString&)>& block,
                               const QStringList& with) const {
  QHash<QString, QString> blocks;
  const auto find = [&](const QString& name) {
    if (!blocks.contains(name)) {
      blocks.insert(name, block(name));
    }
    return blocks.value(name);
  };
  QString page;
  std::vector<bool> left_out{false};  // of the open sections
  for (const Part& part : parts_) {
    if (part.kind == Kind::end) {
      left_out.pop_back();
    } else if (part.kind == Kind::begin_asked) {
      left_out.push_back(left_out.back() || !is_asked(with, part.text));
    } else if (part.kind == Kind::begin) {
      left_out.push_back(left_out.back() || find(part.text).isEmpty());
    } else if (!left_out.back()) {
      QStringList found;
      for (const QString& name : part.blocks) {
        found.append(find(name));
      }
      page += part.kind == Kind::text    ? part.text
              : part.kind == Kind::block ? find(part.text)
                                         : with_blocks(word_of_template(part.text), found);
    }
  }
  return page;
}

QStringList ReportTemplate::placeholders(const QStringList& with) const {
  QStringList names;
  std::vector<bool> left_out{false};
  for (const Part& part : parts_) {
    if (part.kind == Kind::end) {
      left_out.pop_back();
      continue;
    }
    if (part.kind == Kind::begin || part.kind == Kind::begin_asked) {
      left_out.push_back(left_out.back() || (part.kind == Kind::begin_asked && !is_asked(with, part.text)));
    }
    const bool named = part.kind == Kind::block || part.kind == Kind::begin;
    for (const QString& name : named ? QStringList{part.text} : part.blocks) {
      if (!left_out.back() && !names.contains(name)) {
        names.append(name);
      }
    }
  }
  return names;
}

QStringList ReportTemplate::sections() const {
  QStringList names;
  for (const Part& part : parts_) {
    if (part.kind == Kind::begin_asked && !names.contains(part.text)) {
      names.append(part.text);
    }
  }
  return names;
}

QString shipped_template() {
  return QString::fromStdString((data_folder() / "resources" / "report" / "report.html").string());
}

QString read_template(const QString& file) {
  QFile input(file);
  const auto fail = [&](const Message& reason) {
    throw InputError(message(NC_("core", "cannot read the template '{}': {}"), file.toStdString(), reason));
  };
  if (!input.open(QIODevice::ReadOnly)) {
    fail(Message::as_written(input.errorString().toStdString()));
  }
  if (input.size() > largest_template) {
    fail(message(NC_("core", "it has {} bytes, and a template may have {}"), input.size(), largest_template));
  }
  const QByteArray bytes = input.readAll();
  if (input.error() != QFileDevice::NoError) {
    fail(Message::as_written(input.errorString().toStdString()));
  }
  return QString::fromUtf8(bytes);
}

}  // namespace feedscope::ui
