#include "core/analysis/study/compare.h"
#include "core/base/units.h"
#include "core/export/json_parts.h"

namespace feedscope {
namespace {

Json figures_json(const LoadFigureList& figures) {
  Json json = Json::object();
  for (std::size_t i = 0; i < load_quantity_count; ++i) {
    const LoadQuantity& quantity = load_quantities()[i];
    const LoadFigure& figure = figures[i];
    json[std::string(info_of(quantity.id).column)] = {{"max", finite(in_file_unit(quantity, figure.largest))},
                                                      {"line", figure.line},
                                                      {"time_s", finite(figure.time)},
                                                      {"mean", finite(in_file_unit(quantity, figure.mean))}};
  }
  return json;
}

/// Null without any cutting.
Json totals_json(const LoadTotals& totals, const LoadFigureList LoadTotals::*figures) {
  return totals.cutting_time > 0 ? figures_json(totals.*figures) : Json();
}

Json lines_json(const std::vector<ProgramLines>& ranges) {
  Json list = Json::array();
  for (const ProgramLines& range : ranges) {
    list.push_back({range.first, range.last});
  }
  return list;
}

Json operations_json(const LoadSetup& setup, const LoadFigures& load) {
  Json list = Json::array();
  for (std::size_t i = 0; i < load.operations.size(); ++i) {
    const Engagement& operation = setup.operations[i];
    const LoadTotals& totals = load.operations[i];
    list.push_back({{"tool", operation.tool.empty() ? Json() : Json(operation.tool)},
                    {"lines", lines_json(operation.lines)},
                    {"material", operation.material},
                    {"cutting_time_s", finite(totals.cutting_time)},
                    {"predicted", totals_json(totals, &LoadTotals::predicted)},
                    {"programmed", totals_json(totals, &LoadTotals::programmed)}});
  }
  return list;
}

Json limit_json(const LimitFigures& limit) {
  const LoadQuantity& quantity = load_quantities()[quantity_of(limit.limit)];
  Json places = Json::array();
  for (const LoadPlace& place : limit.places) {
    places.push_back({{"operation", place.operation},
                      {"from_s", finite(place.from)},
                      {"to_s", finite(place.to)},
                      {"first_line", place.first_line},
                      {"last_line", place.last_line},
                      {"worst", finite(in_file_unit(quantity, place.worst))}});
  }
  return {{"bound", key_of(limit.limit)},
          {"time_s", finite(limit.time)},
          {"programmed_time_s", finite(limit.programmed_time)},
          {"count", limit.count},
          {"places", places}};
}

}  // namespace

Json load_json(const ComparedRun& run) {
  if (!run.summary.load) {
    return nullptr;
  }
  const LoadFigures& load = *run.summary.load;
  Json without = Json::object();
  for (std::size_t i = 1; i < load_state_count; ++i) {
    without[std::string(key_of(static_cast<LoadState>(i)))] = finite(load.time[i]);
  }
  Json limits = Json::array();
  for (const LimitFigures& limit : load.limits) {
    limits.push_back(limit_json(limit));
  }
  return {{"assumptions", load_assumptions()},
          {"cutting_time_s", finite(load.all.cutting_time)},
          {"time_without_load_s", without},
          {"predicted", totals_json(load.all, &LoadTotals::predicted)},
          {"programmed", totals_json(load.all, &LoadTotals::programmed)},
          {"operations", operations_json(run.setup.load, load)},
          {"limits", limits}};
}

}  // namespace feedscope
