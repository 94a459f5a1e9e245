#include "core/export/identification.h"

#include "core/base/units.h"
#include "core/export/json_parts.h"

namespace feedscope {
namespace {

Json parameters_json(const Identification& found) {
  Json parameters = Json::object();
  for (const IdentifiedParameter& one : found.parameters) {
    parameters[one.parameter.key] = {
        {"value", finite(one.value)}, {"uncertainty", one.told ? finite(one.uncertainty) : Json(nullptr)},
        {"told", one.told},           {"unit", one.parameter.unit},
        {"start", finite(one.start)}, {"at_least", one.at_least ? finite(*one.at_least) : Json(nullptr)},
        {"reason", one.reason},       {"told_by", one.told_by}};
  }
  return parameters;
}

Json drives_json(const Identification& found) {
  Json drives = Json::array();
  for (const DriveFit& drive : found.drives) {
    drives.push_back({{"axis", std::string(1, drive.axis)},
                      {"explains", drive.explains},
                      {"samples", drive.samples},
                      {"following_error_um", finite(units::to_um(drive.following_error))},
                      {"left_um", finite(units::to_um(drive.left))},
                      {"delay_ms", finite(units::to_ms(drive.delay))}});
  }
  return drives;
}

Json agreement_json(const Agreement& agreement) {
  const bool sampled = agreement.rate.period > 0;
  return {{"period_s", sampled ? Json(agreement.rate.period) : Json()},
          {"period_from", sampled ? Json(to_string(agreement.rate.clock)) : Json()},
          {"cycle_time_s", finite(agreement.simulated_time)},
          {"measured_s", finite(agreement.measured_time)},
          {"feed_rms_mm_min", finite(units::to_mm_min(agreement.feed_rms))},
          {"distance_mm", finite(agreement.distance)},
          {"simulated_distance_mm", finite(agreement.simulated_distance)}};
}

Json model_json(const Identification& found, const std::vector<std::string>& traces) {
  Json by_trace = Json::array();
  for (std::size_t i = 0; i < found.agreements.size(); ++i) {
    Json one = agreement_json(found.agreements[i]);
    one["trace"] = i < traces.size() ? traces[i] : "";
    one["program"] = found.runs[i].input.program->source->name();
    Json sections = Json::array();
    for (const SectionAgreement& section : found.sections[i]) {
      sections.push_back({{"section", section.section},
                          {"measured_s", finite(section.measured_time)},
                          {"simulated_s", finite(section.simulated_time)}});
    }
    one["sections"] = std::move(sections);
    by_trace.push_back(std::move(one));
  }
  return {{"id", found.setup.model->info().id}, {"explains", found.explains},
          {"residual", finite(found.residual)}, {"feed_error", finite(found.feed_error)},
          {"simulations", found.simulations},   {"parameters", parameters_json(found)},
          {"drives", drives_json(found)},       {"traces", by_trace}};
}

}  // namespace

std::string identification_json(std::span<const Identification> models,
                                const std::vector<std::string>& traces,
                                std::span<const UnfittedModel> unfitted) {
  Json json = with_format("identification");
  if (!models.empty()) {
    json["parameters"] = parameters_json(models.front());
    json["agreement"] =
        models.front().agreements.empty() ? Json(nullptr) : agreement_json(models.front().agreements.front());
  }
  Json list = Json::array();
  for (const Identification& found : models) {
    list.push_back(model_json(found, traces));
  }
  json["models"] = std::move(list);
  json["unfitted"] = Json::array();
  for (const UnfittedModel& one : unfitted) {
    json["unfitted"].push_back({{"id", one.id}, {"reason", one.reason.english()}});
  }
  return text_of(json);
}

}  // namespace feedscope
