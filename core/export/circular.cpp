#include "core/export/circular.h"

#include <fmt/format.h>

#include "core/base/units.h"
#include "core/export/json_parts.h"

namespace feedscope {
namespace {

Json micrometres_or_null(const std::optional<double>& length) {
  return length ? Json(units::to_um(*length)) : Json(nullptr);
}

std::string micrometres_or_nothing(const std::optional<double>& length) {
  return length ? fmt::format("{:.11g}", units::to_um(*length)) : std::string();
}

Json head_of(const Setup& setup) {
  Json json = with_format("circular");
  const ModelInfo& model = setup.model->info();
  json["machine"] = {
      {"id", setup.machine.id}, {"name", setup.machine.name}, {"control", setup.machine.control}};
  json["model"] = {{"id", model.id}, {"title", model.title}, {"reference", model.reference}};
  json["settings"] = settings_values(setup.settings);
  json["drives"] = drives_json(setup.machine);
  return json;
}

Json entry_of(const CircularTest& test, const CirclePass& pass) {
  const CircularRequest& asked = test.request;
  const Circularity& found = pass.circularity;
  return {{"radius_mm", asked.radius},
          {"feed_mm_min", units::to_mm_min(asked.feed)},
          {"plane", info_of(asked.plane).name},
          {"start_deg", units::to_deg(pass.start)},
          {"sweep_deg", units::to_deg(asked.sweep)},
          {"entry_radius_mm", asked.entry_radius > 0 ? Json(asked.entry_radius) : Json(nullptr)},
          {"path", test.path()},
          {"reached_feed_mm_min", units::to_mm_min(pass.reached_feed)},
          {"time_s", pass.time},
          {"direction", pass.direction()},
          {"G_um", units::to_um(found.zone)},
          {"G_ls_um", units::to_um(found.by_squares)},
          {"Gb_um", micrometres_or_null(test.g_b())},
          {"Fmax_um", units::to_um(found.largest)},
          {"Fmin_um", units::to_um(found.smallest)},
          {"D_um", micrometres_or_null(test.d())}};
}

constexpr const char* columns =
    "radius_mm,feed_mm_min,plane,direction,reached_feed_mm_min,time_s,G_um,G_ls_um,Gb_um,Fmax_um,Fmin_um,"
    "D_um";

std::string row_of(const CircularTest& test, const CirclePass& pass) {
  const Circularity& found = pass.circularity;
  return fmt::format("{:.11g},{:.11g},{},{},{:.11g},{:.11g},{:.11g},{:.11g},{},{:.11g},{:.11g},{}",
                     test.request.radius, units::to_mm_min(test.request.feed),
                     info_of(test.request.plane).name, pass.direction(), units::to_mm_min(pass.reached_feed),
                     pass.time, units::to_um(found.zone), units::to_um(found.by_squares),
                     micrometres_or_nothing(test.g_b()), units::to_um(found.largest),
                     units::to_um(found.smallest), micrometres_or_nothing(test.d()));
}

}  // namespace

std::string circular_json(const Setup& setup, std::span<const CircularTest> tests) {
  Json json = head_of(setup);
  Json list = Json::array();
  for (const CircularTest& test : tests) {
    for (const CirclePass& pass : test.passes) {
      list.push_back(entry_of(test, pass));
    }
  }
  json["circular"] = std::move(list);
  return text_of(json);
}

std::string circular_csv(std::span<const CircularTest> tests) {
  std::string text = fmt::format("{}\n", columns);
  for (const CircularTest& test : tests) {
    for (const CirclePass& pass : test.passes) {
      text += row_of(test, pass) + "\n";
    }
  }
  return text;
}

std::string program_circles_json(const Setup& setup, const Program& program, const ProgramCircles& circles) {
  Json json = head_of(setup);
  json["program"] = {{"file", program.source->name()},
                     {"full_circles", circles.found},
                     {"evaluated_circles", circles.evaluated},
                     {"helices", circles.helices},
                     {"tilted_circles", circles.tilted}};
  Json list = Json::array();
  for (const CircularTest& test : circles.tests) {
    for (const CirclePass& pass : test.passes) {
      Json entry = entry_of(test, pass);
      entry["Fmean_um"] = units::to_um(test.mean_deviation(pass));
      entry["line"] = pass.first_line;
      entry["last_line"] = pass.last_line;
      entry["centre_mm"] = {{"X", test.center.x()}, {"Y", test.center.y()}, {"Z", test.center.z()}};
      entry["evaluated_deg"] = units::to_deg(pass.evaluated);
      list.push_back(std::move(entry));
    }
  }
  json["circular"] = std::move(list);
  return text_of(json);
}

std::string program_circles_csv(const ProgramCircles& circles) {
  std::string text = fmt::format(
      "{},Fmean_um,first_line,last_line,centre_x_mm,centre_y_mm,centre_z_mm,start_deg,sweep_deg,"
      "evaluated_deg,path\n",
      columns);
  for (const CircularTest& test : circles.tests) {
    for (const CirclePass& pass : test.passes) {
      text += fmt::format("{},{:.11g},{},{},{:.11g},{:.11g},{:.11g},{:.11g},{:.11g},{:.11g},{}\n",
                          row_of(test, pass), units::to_um(test.mean_deviation(pass)), pass.first_line,
                          pass.last_line, test.center.x(), test.center.y(), test.center.z(),
                          units::to_deg(pass.start), units::to_deg(test.request.sweep),
                          units::to_deg(pass.evaluated), test.path());
    }
  }
  return text;
}

}  // namespace feedscope
