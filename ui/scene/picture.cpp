#include "ui/scene/picture.h"

#include <fmt/format.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "ui/scene/render_window.h"

namespace feedscope::ui {
namespace {

constexpr int channels = 3;

std::size_t row_bytes(PictureSize size) {
  return static_cast<std::size_t>(size.width) * channels;
}

void copy_rows_upside_down(const unsigned char* from, unsigned char* to, PictureSize size) {
  const std::size_t row = row_bytes(size);
  for (int y = 0; y < size.height; ++y) {
    const auto target = static_cast<std::size_t>(size.height - 1 - y);
    std::memcpy(to + target * row, from + static_cast<std::size_t>(y) * row, row);
  }
}

void check(const char* name, int side) {
  if (side < min_picture_side || side > largest_picture_side) {
    throw InputError(fmt::format("{} of the picture is {} pixels; it must be between {} and {}", name, side,
                                 min_picture_side, largest_picture_side));
  }
}

}  // namespace

double scale_for(PictureSize size) {
  const double ratio = std::min(size.width / 800.0, size.height / 600.0);
  // Text may grow less than the picture: that leaves more room for the path.
  return ratio < 1 ? std::max(0.7, ratio) : std::max(1.0, 0.75 * ratio);
}

Picture draw_picture(PathScene& scene, PictureSize size) {
  check("width", size.width);
  check("height", size.height);
  const auto window = make_render_window(RenderBackend::software);
  scene.attach(*window);
  scene.set_scale(scale_for(size));
  window->SetSize(size.width, size.height);
  window->Render();
  const vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size.width - 1, size.height - 1, 0, pixels, 0);
  scene.detach();
  Picture picture{size, std::vector<unsigned char>(row_bytes(size) * static_cast<std::size_t>(size.height))};
  copy_rows_upside_down(pixels->GetPointer(0), picture.rgb.data(), size);
  return picture;
}

Picture draw_run(const Run& run, PictureSize size, StandardView view) {
  PathScene scene;
  scene.set_programmed(run.path.toolpath);
  scene.set_executed(run.trajectory, std::make_shared<const SampledPath>(sample_executed(
                                         run.trajectory, default_max_points, {}, nullptr, run.sources)));
  scene.set_standard_view(view);
  return draw_picture(scene, size);
}

std::string to_png(const Picture& picture) {
  const vtkNew<vtkImageData> image;
  image->SetDimensions(picture.size.width, picture.size.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, channels);
  copy_rows_upside_down(picture.rgb.data(), static_cast<unsigned char*>(image->GetScalarPointer()),
                        picture.size);
  const vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  constexpr int smallest = 9;
  writer->SetCompressionLevel(smallest);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray& bytes = *writer->GetResult();
  return {reinterpret_cast<const char*>(bytes.GetPointer(0)),
          static_cast<std::size_t>(bytes.GetNumberOfValues())};
}

Picture read_png(const std::string& file) {
  const vtkNew<vtkPNGReader> reader;
  if (reader->CanReadFile(file.c_str()) == 0) {
    throw InputError(fmt::format("cannot read '{}' as a PNG picture", file));
  }
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  if (image.GetScalarType() != VTK_UNSIGNED_CHAR || image.GetNumberOfScalarComponents() != channels) {
    throw InputError(fmt::format("'{}' is not a PNG picture with 8 bits each of red, green and blue", file));
  }
  const PictureSize size{image.GetDimensions()[0], image.GetDimensions()[1]};
  Picture picture{size, std::vector<unsigned char>(row_bytes(size) * static_cast<std::size_t>(size.height))};
  copy_rows_upside_down(static_cast<const unsigned char*>(image.GetScalarPointer()), picture.rgb.data(),
                        size);
  return picture;
}

}  // namespace feedscope::ui
