#include "ui/report/report_template.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <QFile>
#include <QHash>

#include "core/base/data_folder.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"

namespace feedscope::ui {

namespace {

constexpr qint64 largest_template = 16 << 20;  // [bytes]; pictures may be inside

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

/// As it stands in a template.
std::string braced(const QString& name, const char* sign = "") {
  return "'{{" + (sign + name.toStdString()) + "}}'";
}

[[noreturn]] void refuse_unknown(const std::string& place, const QString& name, const QStringList& known) {
  const std::vector<std::string> names = as_std(known);
  const std::string near = nearest_name(name.toStdString(), names);
  throw InputError(place + ": unknown placeholder " + braced(name) + "; " +
                   (near.empty() ? fmt::format("known: {}", fmt::join(names, ", "))
                                 : "did you mean " + braced(QString::fromStdString(near)) + "?"));
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
      throw InputError(place + ": '{{' without '}}'");
    }
    at = end + 2;
    add(text.mid(begin + 2, end - begin - 2).trimmed(), place, known, open);
  }
  parts_.push_back({Kind::text, text.mid(at)});
  if (!open.empty()) {
    throw InputError(open.back().place + ": section " + braced(open.back().name, "#") +
                     " is not closed; write " + braced(open.back().name, "/") + " after it");
  }
}

void ReportTemplate::add(const QString& word, const std::string& place, const QStringList& known,
                         std::vector<Open>& open) {
  if (word.startsWith('!')) {
    return;
  }
  const Kind kind = word.startsWith('#') ? Kind::begin : word.startsWith('/') ? Kind::end : Kind::block;
  const QString name = kind == Kind::block ? word : word.mid(1).trimmed();
  if (!known.contains(name)) {
    refuse_unknown(place, name, known);
  }
  if (kind == Kind::begin) {
    open.push_back({name, place});
  } else if (kind == Kind::end) {
    if (open.empty() || open.back().name != name) {
      throw InputError(place + ": " + braced(name, "/") + " closes no section" +
                       (open.empty() ? "" : "; " + braced(open.back().name, "#") + " is open"));
    }
    open.pop_back();
  }
  parts_.push_back({kind, name});
}

QString ReportTemplate::filled(const std::function<QString(const QString&)>& block) const {
  QHash<QString, QString> blocks;
  const auto find = [&](const QString& name) {
    if (!blocks.contains(name)) {
      blocks.insert(name, block(name));
    }
    return blocks.value(name);
  };
  QString page;
  int left_out = 0;  // sections about the part that have an empty block
  for (const Part& part : parts_) {
    switch (part.kind) {
      case Kind::text:
        page += left_out > 0 ? QString() : part.text;
        break;
      case Kind::block:
        page += left_out > 0 ? QString() : find(part.text);
        break;
      case Kind::begin:
        left_out += find(part.text).isEmpty() ? 1 : 0;
        break;
      case Kind::end:
        left_out -= find(part.text).isEmpty() ? 1 : 0;
        break;
    }
  }
  return page;
}

QStringList ReportTemplate::placeholders() const {
  QStringList names;
  for (const Part& part : parts_) {
    if (part.kind != Kind::text && !names.contains(part.text)) {
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
  const auto fail = [&](const std::string& reason) {
    throw InputError(fmt::format("cannot read the template '{}': {}", file.toStdString(), reason));
  };
  if (!input.open(QIODevice::ReadOnly)) {
    fail(input.errorString().toStdString());
  }
  if (input.size() > largest_template) {
    fail(fmt::format("it has {} bytes, and a template may have {}", input.size(), largest_template));
  }
  const QByteArray bytes = input.readAll();
  if (input.error() != QFileDevice::NoError) {
    fail(input.errorString().toStdString());
  }
  return QString::fromUtf8(bytes);
}

}  // namespace feedscope::ui
