#include <algorithm>
#include <iterator>

#include "core/analysis/contour/contour_errors.h"
#include "core/analysis/study/compare.h"
#include "core/analysis/time/time_report.h"
#include "core/base/units.h"
#include "core/export/export.h"
#include "core/export/json_parts.h"

namespace feedscope {
namespace {

Json kinds_json(const TimeUse& use) {
  Json list = Json::array();
  for (std::size_t i = 0; i < time_kind_count; ++i) {
    const TimeShare& share = use.kinds[i];
    if (share.time > 0 || share.programmed > 0) {
      list.push_back({{"kind", time_kind_key(static_cast<TimeKind>(i))},
                      {"time_s", finite(share.time)},
                      {"programmed_s", finite(share.programmed)}});
    }
  }
  return list;
}

Json causes_json(const TimeUse& use) {
  Json list = Json::array();
  for (const CauseCost& cost : use.causes) {
    list.push_back(
        {{"cause", cause_key(cost.cause)}, {"time_s", finite(cost.time)}, {"lost_s", finite(cost.lost)}});
  }
  return list;
}

Json operations_json(const TimeUse& use) {
  Json list = Json::array();
  for (const OperationTime& operation : use.operations) {
    list.push_back({{"title", operation.title},
                    {"line", operation.line},
                    {"start_s", finite(operation.start)},
                    {"time_s", finite(operation.all.time)},
                    {"programmed_s", finite(operation.all.programmed)},
                    {"rapid_s", finite(operation.rapid)},
                    {"pause_s", finite(operation.pause)},
                    {"worst_cause", cause_key(operation.worst.cause)},
                    {"worst_cause_lost_s", finite(operation.worst.lost)}});
  }
  return list;
}

Json place_json(const SlowPlace& place) {
  return {{"line", place.line},
          {"first_line", place.first_line},
          {"last_line", place.last_line},
          {"from_s", finite(place.from)},
          {"to_s", finite(place.to)},
          {"slowest_s", finite(place.slowest)},
          {"lost_s", finite(place.loss)},
          {"feed_mm_min", finite(units::to_mm_min(place.feed))},
          {"programmed_feed_mm_min", finite(units::to_mm_min(place.programmed_feed))},
          {"cause", cause_key(place.cause)}};
}

/// Null for a shape without a measure; the unit is part of the key, as everywhere.
Json measure_json(const SlowGroup& group) {
  const PlaceShapeInfo& info = info_of(group.shape);
  if (info.measure.empty()) {
    return nullptr;
  }
  const bool angle = info.dimension == Dimension::angle;
  const std::string unit = angle ? "_deg" : "_mm";
  const auto value = [&](double inside) { return finite(angle ? units::to_deg(inside) : inside); };
  return {{"what", info.measure},
          {"min" + unit, value(group.smallest)},
          {"median" + unit, value(group.median)},
          {"max" + unit, value(group.largest)}};
}

Json groups_json(const SlowGroups& slow) {
  Json list = Json::array();
  for (const SlowGroup& group : slow.groups) {
    Json places = Json::array();
    std::ranges::transform(group.worst, std::back_inserter(places), place_json);
    list.push_back({{"shape", info_of(group.shape).key},
                    {"cause", cause_key(group.cause)},
                    {"count", group.count},
                    {"lost_s", finite(group.loss)},
                    {"first_line", group.first_line},
                    {"last_line", group.last_line},
                    {"measure", measure_json(group)},
                    {"places", std::move(places)}});
  }
  return list;
}

Json change_json(const TriedChange& change, const Setup& setup, double cycle_time) {
  const bool done = change.failure.empty();
  Json settings = Json::object();
  for (const auto& [key, value] : change.remedy.changes) {
    std::visit([&, &name = key](const auto& v) { settings[name] = v; }, value);
  }
  return {{"settings", std::move(settings)},
          {"feed_factor", feed_factor(change.remedy, setup)},
          {"machine", change.remedy.machine.empty() ? Json() : Json(change.remedy.machine)},
          {"options", as_options(change.remedy, setup)},
          {"cycle_time_s", done ? finite(change.cycle_time) : Json()},
          {"gain_s", done ? finite(cycle_time - change.cycle_time) : Json()},
          {"max_contour_error_mm",
           change.max_contour_error ? finite(rounded_error(*change.max_contour_error)) : Json()},
          {"max_contour_error_cutting_mm",
           change.cutting_contour_error ? finite(rounded_error(*change.cutting_contour_error)) : Json()},
          {"failure", done ? Json() : Json(change.failure)}};
}

Json changes_json(const TimeReport& report, const Setup& setup) {
  Json list = Json::array();
  const ChangeTrials& trials = report.changes;
  for (std::size_t i = 0; i < trials.tried.size(); ++i) {
    const auto rank = std::ranges::find(trials.best, i);
    Json entry{{"rank", rank == trials.best.end() ? Json() : Json(rank - trials.best.begin() + 1)},
               {"kind", kind_of(trials.tried[i].remedy)}};
    entry.update(change_json(trials.tried[i], setup, report.use.cycle_time));
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace

std::string explanation_json(const Run& run, const ComparedRun& figures, const TimeReport& report) {
  Json json = with_format("explanation");
  json.update(run_head_json(run, figures));
  const auto figure = [&](double value) { return figures.refused ? Json() : finite(value); };
  const auto table = [&](const auto& make, const auto& of) {
    return figures.refused ? Json::array() : make(of);
  };
  json["lost_s"] = figure(report.use.lost());
  json["saved_by_path_s"] = figure(report.use.saved_by_path);
  json["time_by_kind"] = table(kinds_json, report.use);
  json["causes"] = table(causes_json, report.use);
  json["operations_by"] = figures.refused || report.use.operations.empty() ? Json()
                          : report.use.split == OperationSplit::tool       ? Json("tool")
                                                                           : Json("comment");
  json["operations"] = table(operations_json, report.use);
  json["slow_groups"] = table(groups_json, report.slow);
  json["slow_other_s"] = figure(report.slow.other);
  json["changes"] = figures.refused ? Json::array() : changes_json(report, run.setup);
  json["changes_together"] = report.changes.together && !figures.refused
                                 ? change_json(*report.changes.together, run.setup, report.use.cycle_time)
                                 : Json();
  json.update(run_end_json(run, figures));
  return text_of(json);
}

}  // namespace feedscope
