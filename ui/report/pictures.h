#pragma once

#include <QImage>
#include <memory>
#include <optional>
#include <string>

#include "ui/paper/picture_file.h"
#include "ui/report/report_input.h"
#include "ui/report/report_pictures.h"
#include "ui/shared/lens_picture.h"

namespace feedscope::ui {

/// Format and appearance of a picture file.
struct PictureRequest {
  PictureFormat format = PictureFormat::png;
  QSizeF size;                  ///< size of the layout [1/96 inch]
  double pixel_ratio = 1;       ///< pixels of rasters per unit
  std::optional<QSizeF> paper;  ///< [mm] for SVG and PDF; none: 96 units per inch
  ThemeKind theme = ThemeKind::light;
  bool transparent = false;
};

/// Programmed and executed path of the current run with the annotations and a caption below; vectors where
/// the format has them (ScenePicture::paint). This and the following functions return the file's bytes, need
/// a QApplication with the theme, and throw InputError for a size out of bounds.
std::string scene_file(const ReportInput& input, const PictureRequest& request);
/// Charts of the current run as vectors, with the other runs under its curves.
std::string charts_file(const ReportInput& input, const PictureRequest& request);
/// A lens and the drawing styles of its runs.
struct LensShot {
  Lens lens;
  std::vector<LensLook> looks;
};
/// All moving runs at the place of the current run at `time` [s].
LensShot lens_shot(const ReportInput& input, double time);
/// The shot as a picture of a report, which shares `shot`.
ReportPicture lens_picture(std::shared_ptr<const LensShot> shot, const QSizeF& size);
/// All runs through the lens at the place of the current run at `time` [s] (LensPicture).
std::string lens_file(const ReportInput& input, double time, const PictureRequest& request);
/// The picture of card `number` of the report, from 1, for the run that it recommends. Throws InputError for
/// a number without a card.
std::string place_file(const ReportInput& input, std::size_t number, const PictureRequest& request);
/// The file of paint_sheet().
std::string sheet_file(const ReportInput& input, const PictureRequest& request);
/// The file of an existing picture, of the window.
std::string image_file(const QImage& image, const PictureRequest& request, const QString& title);

}  // namespace feedscope::ui
