#include "ui/film/ogg_film.h"

#include "core/base/error.h"

#ifdef FEEDSCOPE_WITH_THEORA

#include <vtkCallbackCommand.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <vector>

namespace feedscope::ui {

namespace {

constexpr int best_quality = 2;

/// Whether the last page has the end mark, which is missing in a file on a full disk.
bool has_end(const std::string& file) {
  constexpr std::streamoff largest_page = 65'307;
  constexpr int flags = 5;  // offset in the head of a page
  constexpr char end_of_stream = 4;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = in.tellg();
  std::vector<char> tail(static_cast<std::size_t>(std::clamp<std::streamoff>(size, 0, largest_page)));
  in.seekg(size - static_cast<std::streamoff>(tail.size()));
  in.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  const std::string mark = "OggS";
  const auto page = std::find_end(tail.begin(), tail.end(), mark.begin(), mark.end());
  return in && tail.end() - page > flags && (page[flags] & end_of_stream) != 0;
}

}  // namespace

class OggFilm::Impl {
 public:
  Impl(const std::string& file, int fps, const std::string& name) : file_(file), name_(name) {
    failure_->SetClientData(this);  // instead of VTK's own message on standard error
    failure_->SetCallback(
        [](vtkObject*, unsigned long, void* self, void*) { static_cast<Impl*>(self)->failed_ = true; });
    writer_->AddObserver(vtkCommand::ErrorEvent, failure_);
    writer_->AddObserver(vtkCommand::WarningEvent, failure_);
    writer_->SetFileName(file.c_str());
    writer_->SetRate(fps);
    writer_->SetQuality(best_quality);
    writer_->SetSubsampling(0);  // so that thin lines keep their colours
    writer_->SetInputData(image_);
  }
  ~Impl() {
    if (begun_) {
      writer_->End();
    }
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void add(const QImage& frame) {
    const QImage rgb = frame.convertToFormat(QImage::Format_RGB888);
    if (!begun_) {
      image_->SetDimensions(rgb.width(), rgb.height(), 1);
      image_->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
      writer_->Start();
      begun_ = true;
    }
    auto* const pixels = static_cast<unsigned char*>(image_->GetScalarPointer());
    const std::size_t row = static_cast<std::size_t>(rgb.width()) * 3;
    for (int y = 0; y < rgb.height(); ++y) {  // VTK begins with the lowest row
      std::memcpy(pixels + static_cast<std::size_t>(rgb.height() - 1 - y) * row, rgb.constScanLine(y), row);
    }
    image_->Modified();
    writer_->Write();
    check(!failed_ && writer_->GetError() == 0);
  }

  void finish() {
    writer_->End();
    begun_ = false;
    check(!failed_ && has_end(file_));
  }

 private:
  void check(bool written) const {
    if (!written) {
      throw InputError(message(NC_("core", "cannot write '{}': {}"), name_,
                               NC_("core", "not everything could be written; is there room for it?")));
    }
  }

  std::string file_;
  std::string name_;
  vtkNew<vtkImageData> image_;
  vtkNew<vtkCallbackCommand> failure_;
  vtkNew<vtkOggTheoraWriter> writer_;
  bool failed_ = false;
  bool begun_ = false;
};

bool OggFilm::is_available() {
  return true;
}

OggFilm::OggFilm(const std::string& file, int fps, const std::string& name)
    : impl_(std::make_unique<Impl>(file, fps, name)) {}

void OggFilm::add(const QImage& frame) {
  impl_->add(frame);
}

void OggFilm::finish() {
  impl_->finish();
}

#else

namespace feedscope::ui {

class OggFilm::Impl {};

bool OggFilm::is_available() {
  return false;
}

OggFilm::OggFilm(const std::string& /*file*/, int /*fps*/, const std::string& name) {
  throw InputError(message(NC_("core", "cannot write '{}': {}"), name,
                           NC_("core", "this build of Feedscope has no Theora video")));
}

void OggFilm::add(const QImage& /*frame*/) {}

void OggFilm::finish() {}

#endif

OggFilm::~OggFilm() = default;

}  // namespace feedscope::ui
