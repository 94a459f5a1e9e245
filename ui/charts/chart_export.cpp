#include "ui/charts/chart_export.h"

#include <QCoreApplication>
#include <QDir>
#include <QSaveFile>
#include <cmath>
#include <optional>
#include <ostream>
#include <streambuf>

#include "core/base/error.h"
#include "core/export/export.h"
#include "ui/paper/picture_file.h"

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

void save_picture(const QString& file, QSize size, const QString& title,
                  const std::function<void(QPainter&)>& draw) {
  PictureSpec spec;
  spec.format = picture_format_of(file.toStdString());
  spec.size = size;
  spec.scale = 2;
  spec.title = title;
  write_whole_file(file, QByteArray::fromStdString(make_picture(spec, draw)));
}

}  // namespace feedscope::ui
