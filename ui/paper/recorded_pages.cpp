#include "ui/paper/recorded_pages.h"

#include <QDataStream>
#include <QIODevice>
#include <QPainter>
#include <QPrinter>
#include <algorithm>

#include "core/base/error.h"

namespace feedscope::ui {

namespace {

constexpr double units_a_millimetre = 96 / 25.4;
constexpr quint32 recording_mark = 0x46534450;  // "FSDP"
constexpr quint32 most_pages = 100000;

}  // namespace

void RecordedPages::add(const QSizeF& size, const std::function<void(QPainter&)>& paint, double margin) {
  QPicture picture;
  QPainter painter(&picture);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing |
                         QPainter::LosslessImageRendering);
  const QSizeF room = (paper_ - QSizeF(2 * margin, 2 * margin)) * units_a_millimetre;
  const double unit = std::min(room.width() / size.width(), room.height() / size.height());
  painter.translate(margin * units_a_millimetre, margin * units_a_millimetre);
  painter.scale(unit, unit);
  paint(painter);
  painter.end();
  pages_.append(picture);
}

void RecordedPages::draw(QPainter& painter, qsizetype page, const QRectF& area) const {
  const QSizeF units = paper_ * units_a_millimetre;
  const double unit = std::min(area.width() / units.width(), area.height() / units.height());
  painter.save();
  painter.translate(area.center() - QPointF(units.width(), units.height()) * unit / 2);
  QPicture picture = pages_[page];
  // QPicture::play() scales by the device's resolution; here `area` determines the size.
  const double enlarged = static_cast<double>(painter.device()->logicalDpiX()) / picture.logicalDpiX();
  painter.scale(unit / enlarged, unit / enlarged);
  picture.play(&painter);
  painter.restore();
}

void RecordedPages::print(QPrinter& printer) const {
  const qsizetype first = printer.fromPage() > 0 ? printer.fromPage() - 1 : 0;
  const qsizetype last = printer.toPage() > 0 ? std::min<qsizetype>(printer.toPage(), count()) : count();
  QPainter painter(&printer);
  const QRectF sheet(QPointF(), printer.paperRect(QPrinter::DevicePixel).size());
  for (qsizetype page = first; page < last; ++page) {
    if (page > first) {
      printer.newPage();
    }
    draw(painter, page, sheet);
  }
}

std::string RecordedPages::bytes() const {
  QByteArray bytes;
  QDataStream stream(&bytes, QIODevice::WriteOnly);
  stream << recording_mark << title_ << paper_ << static_cast<quint32>(pages_.size());
  for (const QPicture& page : pages_) {
    stream << page;
  }
  return bytes.toStdString();
}

RecordedPages RecordedPages::from_bytes(const QByteArray& bytes) {
  QDataStream stream(bytes);
  quint32 mark = 0;
  quint32 count = 0;
  RecordedPages pages;
  stream >> mark >> pages.title_ >> pages.paper_ >> count;
  if (stream.status() != QDataStream::Ok || mark != recording_mark || pages.paper_.isEmpty() ||
      count > most_pages) {
    throw InputError("the pages to print are not a recording of Feedscope");
  }
  for (quint32 i = 0; i < count && stream.status() == QDataStream::Ok; ++i) {
    QPicture page;
    stream >> page;
    pages.pages_.append(page);
  }
  if (stream.status() != QDataStream::Ok) {
    throw InputError("the recording of the pages to print ends too early");
  }
  return pages;
}

}  // namespace feedscope::ui
