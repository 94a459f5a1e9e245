#include "ui/page/page.h"

#include <QCryptographicHash>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "ui/page/page_columns.h"
#include "ui/page/page_data.h"

namespace feedscope::ui {
namespace {

QByteArray page_file(const QString& name) {
  QFile file(QStringLiteral(":/page/") + name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Permits only the script of `loader` and the scripts that it unpacks; nothing is fetched.
QString policy(const QByteArray& loader) {
  const QByteArray hash = QCryptographicHash::hash(loader, QCryptographicHash::Sha256).toBase64();
  return QStringLiteral(
             "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src "
             "'sha256-%1' blob:; style-src 'unsafe-inline'; img-src data: blob:; font-src data:; base-uri "
             "'none'; form-action 'none'\"/>")
      .arg(QString::fromLatin1(hash));
}

/// Base64, which has no character that could end the element.
QString kept(const char* id, const QByteArray& bytes) {
  return QStringLiteral("<script type=\"text/plain\" id=\"%1\">%2</script>\n")
      .arg(QLatin1String(id), QString::fromLatin1(bytes.toBase64()));
}

/// Licences of the libraries in the page's script.
QByteArray licences() {
  QJsonArray list;
  for (const char* name : {"three", "uplot"}) {
    const QString file = QStringLiteral("LICENSE.") + QLatin1String(name);
    list.append(QJsonObject{{"name", QLatin1String(name)}, {"text", QString::fromUtf8(page_file(file))}});
  }
  return QJsonDocument(list).toJson(QJsonDocument::Compact);
}

void insert_after(QString& html, const QString& tag, const QString& text) {
  const qsizetype at = html.indexOf(tag, 0, Qt::CaseInsensitive);
  const qsizetype end = at < 0 ? -1 : html.indexOf(QLatin1Char('>'), at);
  html.insert(end < 0 ? 0 : end + 1, text);
}

}  // namespace

QString with_view(QString html, const QByteArray& data) {
  const QByteArray loader = page_file(QStringLiteral("loader.js")).trimmed();
  const QString parts = kept("feedscope-data", data) + kept("feedscope-licences", deflated(licences())) +
                        kept("feedscope-code", deflated(page_file(QStringLiteral("page.js")))) +
                        QStringLiteral("<script>%1</script>\n").arg(QString::fromUtf8(loader));
  const qsizetype end = html.lastIndexOf(QStringLiteral("</body>"), -1, Qt::CaseInsensitive);
  html.insert(end < 0 ? html.size() : end, parts);
  insert_after(html, QStringLiteral("<head"), policy(loader));
  return html;
}

std::string make_page(const ReportInput& input, const ReportTemplate& page, Progress* progress) {
  const std::string report = make_report(input, page, ReportFormat::html, progress);
  return with_view(QString::fromStdString(report), page_data(with_recommended_run(input), progress))
      .toStdString();
}

}  // namespace feedscope::ui
