#include "core/export/trace.h"

#include "core/base/units.h"
#include "core/export/json_parts.h"

namespace feedscope {
namespace {

Json vector_json(const Vec3& v) {
  return Json::array({finite(v.x()), finite(v.y()), finite(v.z())});
}

Json messages_json(const std::vector<Diagnostic>& messages) {
  Json list = Json::array();
  for (const Diagnostic& message : messages) {
    list.push_back({{"severity", to_string(message.severity)},
                    {"line", message.line},
                    {"code", message.code},
                    {"message", message.message.english()},
                    {"hint", message.hint.english()}});
  }
  return list;
}

Json head_of(const Trace& trace) {
  Json json = with_format("trace");
  Json axes = Json::array();
  for (std::size_t axis = 0; axis < trace.place.size(); ++axis) {
    if (trace.has(axis)) {
      axes.push_back(std::string(1, coordinate_names[axis]));
    }
  }
  json["trace"] = {{"file", trace.name},
                   {"format", trace.format},
                   {"samples", trace.size()},
                   {"duration_s", finite(trace.duration())},
                   {"period_s", finite(trace.period)},
                   {"period_from", to_string(trace.clock)},
                   {"jitter_s", finite(trace.jitter)},
                   {"gaps", trace.gaps},
                   {"lost_s", finite(trace.lost)},
                   {"axes", axes},
                   {"columns", trace.columns},
                   {"notes", messages_json(trace.notes)}};
  return json;
}

Json agreement_json(const TraceOnProgram& found, const Agreement& agreement) {
  Json remarks = Json::array();
  for (const Diagnostic& remark : found.remarks) {
    remarks.push_back(remark.message.english());
  }
  Json worst = Json::array();
  for (const WorstPlace& place : agreement.worst) {
    worst.push_back({{"line", place.line},
                     {"path_mm", finite(place.s)},
                     {"place_mm", vector_json(place.place)},
                     {"measured_feed_mm_min", finite(units::to_mm_min(place.measured_feed))},
                     {"simulated_feed_mm_min", finite(units::to_mm_min(place.simulated_feed))},
                     {"lost_s", finite(place.lost)}});
  }
  Json corners = Json::array();
  for (const CornerAgreement& corner : agreement.corners) {
    corners.push_back({{"line", corner.line},
                       {"path_mm", finite(corner.s)},
                       {"place_mm", vector_json(corner.place)},
                       {"turn_deg", finite(units::to_deg(corner.turn))},
                       {"reach_mm", finite(corner.reach)},
                       {"measured_feed_mm_min", finite(units::to_mm_min(corner.measured_feed))},
                       {"simulated_feed_mm_min", finite(units::to_mm_min(corner.simulated_feed))}});
  }
  Json operations = Json::array();
  for (const OperationAgreement& operation : agreement.operations) {
    operations.push_back({{"title", operation.title},
                          {"line", operation.line},
                          {"measured_s", finite(operation.measured_time)},
                          {"simulated_s", finite(operation.simulated_time)}});
  }
  return {{"period_s", finite(agreement.rate.period)},
          {"period_from", to_string(agreement.rate.clock)},
          {"cycle_time_s", finite(agreement.simulated_time)},
          {"measured_s", finite(agreement.measured_time)},
          {"whole", agreement.whole},
          {"path_share", finite(found.share)},
          {"feed_rms_mm_min", finite(units::to_mm_min(agreement.feed_rms))},
          {"distance_mm", finite(agreement.distance)},
          {"simulated_distance_mm", finite(agreement.simulated_distance)},
          {"passes_s", found.pass_times},
          {"noise_um", finite(units::to_um(found.noise))},
          {"scale", finite(found.pose.scale)},
          {"mirror", vector_json(found.pose.mirror)},
          {"offset_mm", vector_json(found.pose.offset)},
          {"belongs", found.belongs()},
          {"trace_share", finite(found.fit.trace_share)},
          {"remarks", remarks},
          {"messages", messages_json(found.remarks)},
          {"worst", worst},
          {"operations", operations},
          {"corner_rms_percent", finite(100 * agreement.corner_rms())},
          {"corners", corners}};
}

}  // namespace

std::string trace_json(const Trace& trace) {
  return text_of(head_of(trace));
}

std::string trace_json(const Trace& trace, const TraceOnProgram& found, const Agreement& agreement,
                       const Run& run) {
  Json json = head_of(trace);
  const ModelInfo& model = run.setup.model->info();
  json["program"] = {{"file", run.input.program->source->name()}};
  json["machine"] = {{"id", run.setup.machine.id}, {"name", run.setup.machine.name}};
  json["model"] = {{"id", model.id}, {"title", model.title}};
  json["settings"] = settings_values(run.setup.settings);
  json["agreement"] = agreement_json(found, agreement);
  return text_of(json);
}

}  // namespace feedscope
