#include <fmt/format.h>

#include "core/base/units.h"
#include "core/export/circular.h"
#include "core/export/json_parts.h"

namespace feedscope {

std::string circular_json(const Setup& setup, std::span<const CircularTest> tests) {
  Json json = with_format("circular");
  const ModelInfo& model = setup.model->info();
  json["machine"] = {
      {"id", setup.machine.id}, {"name", setup.machine.name}, {"control", setup.machine.control}};
  json["model"] = {{"id", model.id}, {"title", model.title}, {"reference", model.reference}};
  json["settings"] = settings_values(setup.settings);
  json["drives"] = drives_json(setup.machine);
  Json list = Json::array();
  for (const CircularTest& test : tests) {
    const CircularRequest& asked = test.request;
    for (const CirclePass& pass : test.passes) {
      const Circularity& found = pass.circularity;
      list.push_back({{"radius_mm", asked.radius},
                      {"feed_mm_min", units::to_mm_min(asked.feed)},
                      {"plane", info_of(asked.plane).name},
                      {"start_deg", units::to_deg(asked.start)},
                      {"sweep_deg", units::to_deg(asked.sweep)},
                      {"entry_radius_mm", asked.entry_radius > 0 ? Json(asked.entry_radius) : Json(nullptr)},
                      {"path", test.actual ? "actual" : "set"},
                      {"reached_feed_mm_min", units::to_mm_min(pass.reached_feed)},
                      {"time_s", pass.time},
                      {"direction", pass.direction()},
                      {"G_um", units::to_um(found.zone)},
                      {"G_ls_um", units::to_um(found.by_squares)},
                      {"Gb_um", units::to_um(test.g_b())},
                      {"Fmax_um", units::to_um(found.largest)},
                      {"Fmin_um", units::to_um(found.smallest)},
                      {"D_um", units::to_um(test.d())}});
    }
  }
  json["circular"] = std::move(list);
  return text_of(json);
}

std::string circular_csv(std::span<const CircularTest> tests) {
  std::string text =
      "radius_mm,feed_mm_min,plane,direction,reached_feed_mm_min,time_s,G_um,G_ls_um,Gb_um,Fmax_um,Fmin_um,"
      "D_um\n";
  for (const CircularTest& test : tests) {
    for (const CirclePass& pass : test.passes) {
      const Circularity& found = pass.circularity;
      text += fmt::format(
          "{:.11g},{:.11g},{},{},{:.11g},{:.11g},{:.11g},{:.11g},{:.11g},{:.11g},{:.11g},{:.11g}\n",
          test.request.radius, units::to_mm_min(test.request.feed), info_of(test.request.plane).name,
          pass.direction(), units::to_mm_min(pass.reached_feed), pass.time, units::to_um(found.zone),
          units::to_um(found.by_squares), units::to_um(test.g_b()), units::to_um(found.largest),
          units::to_um(found.smallest), units::to_um(test.d()));
    }
  }
  return text;
}

}  // namespace feedscope
