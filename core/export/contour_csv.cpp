#include <fmt/format.h>

#include "core/base/units.h"
#include "core/export/contour.h"
#include "core/export/contour_words.h"
#include "core/export/csv_field.h"

namespace feedscope {
namespace {

std::string numbers(const Vec3& v) {
  return csv_number(v.x()) + "," + csv_number(v.y()) + "," + csv_number(v.z());
}

std::string row_of(std::size_t rank, const ContourFinding& finding) {
  using Kind = ContourSpot::Kind;
  const ContourPlace& place = finding.place;
  const ContourSpot& spot = finding.spot;
  return fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", rank, place.line, csv_field(finding.block),
      csv_number(place.time), csv_number(place.path_length), csv_number(rounded_error(place.error)),
      csv_number(rounded_error(place.side)), finding.tolerance ? csv_number(*finding.tolerance) : "",
      contour_word(spot.kind), csv_number(spot.length),
      spot.kind == Kind::corner ? csv_number(units::to_deg(spot.turn)) : "",
      spot.kind == Kind::arc ? csv_number(spot.radius) : "",
      spot.kind == Kind::line ? ""
      : spot.inside           ? "1"
                              : "0",
      numbers(place.position), numbers(place.programmed), csv_number(units::to_mm_min(finding.feed)),
      csv_number(units::to_mm_min(finding.programmed_feed)), cause_key(finding.cause));
}

}  // namespace

std::string contour_places_csv(const ContourReport& report) {
  std::string text =
      "rank,line,block,time_s,path_mm,error_mm,side_mm,tolerance_mm,at,length_mm,turn_deg,radius_mm,inside,"
      "x_mm,y_mm,z_mm,programmed_x_mm,programmed_y_mm,programmed_z_mm,feed_mm_min,programmed_feed_mm_min,"
      "cause\n";
  for (std::size_t i = 0; i < report.worst.size(); ++i) {
    text += row_of(i + 1, report.worst[i]);
  }
  return text;
}

std::string contour_histogram_csv(std::span<const NamedHistogram> histograms) {
  std::string text = "from_mm,to_mm";
  for (const NamedHistogram& named : histograms) {
    text += "," + csv_field(named.run);
  }
  text += "\n";
  if (histograms.empty()) {
    return text;
  }
  const std::vector<double>& edges = histograms.front().histogram.edges;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    text += csv_number(edges[i]) + "," + csv_number(edges[i + 1]);
    for (const NamedHistogram& named : histograms) {
      text += "," + csv_number(named.histogram.length[i]);
    }
    text += "\n";
  }
  return text;
}

}  // namespace feedscope
