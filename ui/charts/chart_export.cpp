#include "ui/charts/chart_export.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QSaveFile>
#include <QSvgGenerator>
#include <cmath>
#include <optional>
#include <ostream>
#include <streambuf>

#include "core/base/error.h"
#include "core/export/export.h"

namespace feedscope::ui {

namespace {

constexpr double max_samples = 2e7;  // about 5 GB

struct ChartExport {
  Q_DECLARE_TR_FUNCTIONS(ChartExport)
};

[[noreturn]] void fail(const QSaveFile& file) {
  throw InputError(ChartExport::tr("cannot write %1: %2")
                       .arg(QDir::toNativeSeparators(file.fileName()), file.errorString())
                       .toStdString());
}

class AtomicFile {
 public:
  explicit AtomicFile(const QString& name) : file_(name) {
    if (!file_.open(QIODevice::WriteOnly)) {
      fail(file_);
    }
  }
  void write(const char* data, qint64 size) {
    if (file_.write(data, size) != size) {
      fail(file_);
    }
  }
  void commit() {
    if (!file_.commit()) {
      fail(file_);
    }
  }

 private:
  QSaveFile file_;
};

/// Lets a std::ostream write to a file.
class FileBuffer : public std::streambuf {
 public:
  explicit FileBuffer(AtomicFile& file) : file_(file) {}

 protected:
  int_type overflow(int_type character) override {
    const char byte = traits_type::to_char_type(character);
    file_.write(&byte, 1);
    return character;
  }
  std::streamsize xsputn(const char* data, std::streamsize size) override {
    file_.write(data, size);
    return size;
  }

 private:
  AtomicFile& file_;
};

}  // namespace

void save_csv(const QString& file, const Trajectory& trajectory, std::span<const double> times,
              const RunSources& sources) {
  AtomicFile target(file);
  FileBuffer buffer(target);
  std::ostream out(&buffer);
  out.exceptions(std::ios::badbit);
  write_csv(out, trajectory, times, nullptr, sources);
  target.commit();
}

std::vector<double> sample_times(const Interval& range, double step) {
  const double count = std::ceil(range.width() / step * (1 - 1e-12));
  if (!(count <= max_samples)) {
    throw InputError(
        ChartExport::tr(
            "a row every %1 s gives more than 20 million rows; show a shorter range or choose a larger step")
            .arg(step)
            .toStdString());
  }
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(count) + 1);
  for (double i = 0; i < count; ++i) {
    times.push_back(range.lower + i * step);
  }
  times.push_back(range.upper);
  return times;
}

std::vector<double> block_times(const Trajectory& trajectory, const Interval& range) {
  std::vector<double> times{range.lower};
  const BlendedPath& path = trajectory.path();
  std::optional<std::uint32_t> block;
  for (const Piece& piece : trajectory.pieces()) {
    const std::uint32_t own = path.segment(piece.element);
    if (own != block && piece.time > times.back() && piece.time < range.upper) {
      times.push_back(piece.time);
    }
    block = own;
  }
  if (range.upper > range.lower) {
    times.push_back(range.upper);
  }
  return times;
}

void write_whole_file(const QString& file, const QByteArray& bytes) {
  AtomicFile target(file);
  target.write(bytes.constData(), bytes.size());
  target.commit();
}

void save_png(const QString& file, QSize size, double scale, const DrawPicture& draw) {
  QImage image((QSizeF(size) * scale).toSize(), QImage::Format_RGB32);
  image.setDevicePixelRatio(scale);
  image.fill(Qt::white);
  QPainter painter(&image);
  draw(painter);
  painter.end();
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  write_whole_file(file, buffer.data());
}

void save_svg(const QString& file, QSize size, const QString& title, const DrawPicture& draw) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(0, 0), size));
  generator.setTitle(title);
  QPainter painter(&generator);
  draw(painter);
  painter.end();
  write_whole_file(file, buffer.data());
}

}  // namespace feedscope::ui
