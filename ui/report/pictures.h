#pragma once

#include <QImage>
#include <memory>
#include <optional>
#include <string>

#include "ui/report/picture_file.h"
#include "ui/report/report_input.h"
#include "ui/report/report_pictures.h"
#include "ui/shared/lens_picture.h"

namespace feedscope::ui {

/// The file that a picture becomes, and how it looks.
struct PictureRequest {
  PictureFormat format = PictureFormat::png;
  QSizeF size;                  ///< what is laid out [1/96 inch]
  double pixel_ratio = 1;       ///< pixels of rasters to a unit
  std::optional<QSizeF> paper;  ///< [mm] for SVG and PDF; none: 96 units an inch
  ThemeKind theme = ThemeKind::light;
  bool transparent = false;
};

/// Programmed and executed path of the current run with the annotations, a caption below; vectors where the
/// format has them (ScenePicture::paint). All of these give the file's bytes, need a QApplication with the
/// theme, and throw InputError where the size is out of bounds.
std::string scene_file(const ReportInput& input, const PictureRequest& request);
/// Charts of the current run as vectors, the other runs behind.
std::string charts_file(const ReportInput& input, const PictureRequest& request);
/// A lens and how its runs are drawn.
struct LensShot {
  Lens lens;
  std::vector<LensLook> looks;
};
/// All runs that move, where the current one is at `time` [s].
LensShot lens_shot(const ReportInput& input, double time);
/// It as a picture of a report; `shot` is shared with it.
ReportPicture lens_picture(std::shared_ptr<const LensShot> shot, const QSizeF& size);
/// All runs through the lens, where the current one is at `time` [s] (LensPicture).
std::string lens_file(const ReportInput& input, double time, const PictureRequest& request);
/// The picture of a card of the report, counted from 1: of the run that it recommends. Throws InputError for
/// a number that it does not have.
std::string place_file(const ReportInput& input, std::size_t number, const PictureRequest& request);
/// paint_sheet().
std::string sheet_file(const ReportInput& input, const PictureRequest& request);
/// A picture that is there already: of the window.
std::string image_file(const QImage& image, const PictureRequest& request, const QString& title);

}  // namespace feedscope::ui
