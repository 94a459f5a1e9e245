#include "ui/report/page_fit.h"

#include <QRegularExpression>
#include <QTextDocument>
#include <algorithm>
#include <cmath>

#include "ui/report/paged_document.h"

namespace feedscope::ui {

namespace {

constexpr double filled_share = 0.75;
constexpr double fit_reserve = 10;  // of rounding [1/96 inch]

double paper_height(const QString& html) {
  QTextDocument document;
  set_on_paper(document, html);
  return document.size().height();
}

/// Names of the elastic pictures in a part of the report.
QStringList elastic_names(const QString& html, const ReportPictures& pictures) {
  QStringList names;
  for (const auto& [name, picture] : pictures.elastic()) {
    if (html.contains(QStringLiteral("\"picture:%1\"").arg(name))) {
      names.append(name);
    }
  }
  return names;
}

QString with_height(QString html, const QString& name, double height) {
  const QRegularExpression image(QStringLiteral("(\"picture:%1\" width=\"[^\"]*\" height=\")[^\"]*")
                                     .arg(QRegularExpression::escape(name)));
  return html.replace(image, QStringLiteral("\\1%1").arg(height));
}

QString with_break(QString html) {
  static const QRegularExpression heading(QStringLiteral("<h2"));
  const qsizetype at = html.indexOf(heading);
  return at < 0 ? html : html.insert(at + 3, QStringLiteral(" style=\"page-break-before: always\""));
}

/// Lowers the elastic pictures of a part evenly by `excess` in total, if their limits permit.
QString lowered(QString html, double excess, ReportPictures& pictures) {
  const QStringList names = elastic_names(html, pictures);
  double slack = 0;
  for (const QString& name : names) {
    slack += pictures.elastic().at(name).largest - pictures.elastic().at(name).least;
  }
  const double share = slack > 0 ? std::min(1.0, excess / slack) : 0;
  for (const QString& name : names) {
    const ElasticPicture& picture = pictures.elastic().at(name);
    const double height = std::floor(picture.largest - share * (picture.largest - picture.least));
    pictures.resize(name, height);
    html = with_height(html, name, height);
  }
  return html;
}

}  // namespace

QString with_filled_pages(const QString& html, ReportPictures& pictures, const Paper& paper) {
  const double page = paper.contents_height();
  QStringList parts = html.split(page_mark);
  const QString head =
      parts.front().section(QStringLiteral("</head>"), 0, 0) + QStringLiteral("</head><body>");
  double filled = 0;  // of the current page
  for (qsizetype i = 0; i < parts.size(); ++i) {
    QString& part = parts[i];
    if (part.simplified().isEmpty()) {
      continue;
    }
    if (filled >= filled_share * page) {
      part = with_break(part);
      filled = 0;
    }
    const double height = paper_height(i == 0 ? part : head + part) + fit_reserve;
    const double room = page - filled;
    if (height <= room) {
      filled += height;
      continue;
    }
    part = lowered(part, height - room, pictures);
    filled = std::fmod(filled + std::max(room, paper_height(i == 0 ? part : head + part)), page);
    filled = filled == 0 ? page : filled;
  }
  return parts.join(QString());
}

}  // namespace feedscope::ui
