// The module feedscope._native: programs, runs and their motion for Python. Its public interface is in
// feedscope/__init__.py.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <optional>
#include <span>

#include "core/analysis/contour/actual_figures.h"
#include "core/analysis/run/quantity.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/export/export.h"
#include "core/trajectory/part_walk.h"
#include "core/trajectory/state_walk.h"

namespace py = pybind11;

namespace feedscope {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Runs `work(progress)` without the interpreter lock, so that other Python threads continue and Ctrl-C
/// cancels it.
template <typename Work>
auto run_interruptible(Work work) {
  Progress progress;
  py::gil_scoped_release released;
  auto result = std::async(std::launch::async, [&] { return work(progress); });
  while (result.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
    py::gil_scoped_acquire acquired;
    if (PyErr_CheckSignals() != 0) {
      progress.cancel();
      {
        py::gil_scoped_release again;
        result.wait();
      }
      throw py::error_already_set();
    }
  }
  return result.get();
}

ReadOptions read_options(const std::optional<std::string>& dialect, const std::optional<std::string>& unit,
                         bool skip_deleted, const std::map<std::string, double>& radii,
                         const std::map<std::string, std::array<double, 3>>& offsets) {
  ReadOptions options;
  if (dialect) {
    options.dialect = dialect_of_id(*dialect);
  }
  if (unit) {
    if (*unit != "mm" && *unit != "inch") {
      throw InputError("unit is '" + *unit + "'; it must be mm or inch");
    }
    options.unit = *unit == "inch" ? LengthUnit::inch : LengthUnit::mm;
  }
  options.skip_deleted_blocks = skip_deleted;
  for (const auto& [tool, radius] : radii) {
    options.radii.set(tool, radius);
  }
  for (const auto& [name, zero] : offsets) {
    options.offsets.set(name, Vec3(zero[0], zero[1], zero[2]));
  }
  return options;
}

LoadedProgram read(std::shared_ptr<const SourceText> source, const ReadOptions& options) {
  return run_interruptible([&](Progress& progress) { return load_program(source, &progress, options); });
}

Setup setup_of(const LoadedProgram& program, const std::string& machine, const std::string& model,
               std::optional<double> tolerance, const std::vector<std::string>& assignments) {
  return make_setup({.machine = machine,
                     .model = model,
                     .tolerance = tolerance,
                     .assignments = assignments,
                     .dialect = program.program->dialect});
}

std::vector<Run> simulate_all(const LoadedProgram& program, const std::vector<Setup>& setups) {
  return run_interruptible([&](Progress& progress) {
    std::vector<Run> runs(setups.size());
    in_parallel(setups.size(), [&](std::size_t i) {
      Progress part(progress, 1.0 / static_cast<double>(setups.size()));
      runs[i] = simulate_run(program, setups[i], &part);
    });
    return runs;
  });
}

py::list cause_names() {
  py::list names;
  for (const Cause cause : all_causes()) {
    names.append(cause_key(cause));
  }
  return names;
}

/// Columns of the CSV at ascending instants, including those of the drives if the machine has any, and
/// `cause` as an index into cause_names().
py::dict samples(const Run& run, const Doubles& instants) {
  const Trajectory& trajectory = *run.trajectory;
  struct Column {
    const QuantityInfo* quantity;
    Doubles values;
  };
  std::vector<Column> columns;
  const std::span<const double> times(instants.data(), static_cast<std::size_t>(instants.size()));
  const std::size_t count = trajectory.pieces().empty() ? 0 : times.size();
  for (const QuantityInfo& quantity : all_quantities()) {
    const bool has = run.sources.has(quantity);
    if (!quantity.column.empty() && has) {
      columns.push_back({&quantity, Doubles(static_cast<py::ssize_t>(count))});
    }
  }
  py::array_t<std::uint8_t> causes(static_cast<py::ssize_t>(count));
  std::vector<double*> places;
  for (Column& column : columns) {
    places.push_back(column.values.mutable_data());
  }
  std::uint8_t* cause = causes.mutable_data();
  run_interruptible([&](Progress& progress) {
    StateWalk walk(trajectory);
    InstantSampler sampler(run.sources);
    ProgressSteps steps(&progress, count);
    for (std::size_t i = 0; i < count; ++i) {
      const State state = walk.at(times[i]);
      const Instant instant = sampler.at(state);
      for (std::size_t k = 0; k < columns.size(); ++k) {
        const QuantityInfo& quantity = *columns[k].quantity;
        places[k][i] = quantity.of(instant) * shown_unit(quantity.dimension).factor;
      }
      cause[i] = static_cast<std::uint8_t>(cause_index(state.cause));
      steps.at(i);
    }
    return true;
  });
  py::dict table;
  for (const Column& column : columns) {
    table[py::str(std::string(column.quantity->column))] = column.values;
  }
  table["cause"] = causes;
  return table;
}

/// Times at every step, and the end of the run [s].
Doubles times_of(const Run& run, double step) {
  constexpr double max_samples = 1e9;
  const double duration = run.trajectory->duration();
  if (!(step > 0) || duration / step > max_samples) {
    throw InputError("a step of " + std::to_string(step) +
                     " s is not above 0 or gives more than a billion samples; use a larger step");
  }
  std::vector<double> times;
  const auto count = static_cast<std::size_t>(std::ceil(duration / step * (1 - 1e-10)));
  times.reserve(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    times.push_back(static_cast<double>(i) * step);
  }
  times.push_back(duration);
  return Doubles(static_cast<py::ssize_t>(times.size()), times.data());
}

/// The exact motion: pieces of constant jerk on one element each.
py::dict pieces(const Run& run) {
  const Trajectory& trajectory = *run.trajectory;
  std::vector<double> time;
  std::vector<double> duration;
  std::vector<double> path;
  std::array<std::vector<double>, 4> law;
  std::vector<std::uint32_t> line;
  std::vector<std::uint32_t> element;
  std::vector<std::uint8_t> kind;
  std::vector<std::uint8_t> cause;
  run_interruptible([&](Progress& progress) {
    ProgressSteps steps(&progress, trajectory.pieces().size());
    for (PartWalk walk(trajectory, 0); !walk.done(); walk.next()) {
      const Part& part = walk.part();
      steps.at(part.piece);
      time.push_back(part.time);
      duration.push_back(part.duration);
      path.push_back(walk.motion().state(0).path_length);
      for (const auto& [column, value] : {std::pair(0, part.q), {1, part.v}, {2, part.a}, {3, part.j}}) {
        law[static_cast<std::size_t>(column)].push_back(part.law == Law::filtered && column > 0 ? std::nan("")
                                                                                                : value);
      }
      line.push_back(trajectory.line_of(part.element));
      element.push_back(part.element);
      kind.push_back(static_cast<std::uint8_t>(part.law));
      cause.push_back(static_cast<std::uint8_t>(cause_index(part.cause)));
    }
    return true;
  });
  py::dict table;
  const auto put = [&table](const char* name, const auto& values) {
    using Value = typename std::decay_t<decltype(values)>::value_type;
    table[name] = py::array_t<Value>(static_cast<py::ssize_t>(values.size()), values.data());
  };
  put("time_s", time);
  put("duration_s", duration);
  put("path_mm", path);
  put("q", law[0]);
  put("v", law[1]);
  put("a", law[2]);
  put("j", law[3]);
  put("line", line);
  put("element", element);
  put("law", kind);
  put("cause", cause);
  return table;
}

}  // namespace
}  // namespace feedscope

PYBIND11_MODULE(_native, module) {
  using namespace feedscope;
  static py::exception<InputError> error(module, "Error", PyExc_ValueError);
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      std::rethrow_exception(std::move(pointer));
    } catch (const InputError& reason) {
      PyErr_SetString(error.ptr(), reason.what());
    } catch (const Cancelled&) {
      PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
  module.attr("version") = FEEDSCOPE_VERSION;
  py::class_<LoadedProgram>(module, "Program").def("json", [](const LoadedProgram& program) {
    return check_json(program, {program.toolpath, {}});
  });
  py::class_<Setup>(module, "Setup");
  py::class_<Run>(module, "Run")
      .def("json", [](const Run& run) { return simulation_json(run, figures_of(run)); })
      .def("times", &times_of)
      .def("samples", &samples)
      .def("pieces", &pieces);
  module.def("read_file", [](const std::filesystem::path& file, const ReadOptions& options) {
    return read(std::make_shared<const SourceText>(SourceText::from_file(file)), options);
  });
  module.def("read_text", [](std::string text, const std::string& name, const ReadOptions& options) {
    return read(std::make_shared<const SourceText>(name, std::move(text)), options);
  });
  py::class_<ReadOptions>(module, "ReadOptions");
  module.def("read_options", &read_options);
  module.def("setup", &setup_of);
  module.def("simulate_all", &simulate_all);
  module.def("cause_names", &cause_names);
  module.def("machine_ids", [] { return shipped_machines().ids(); });
  module.def("model_ids", [] {
    std::vector<std::string> ids;
    for (const ControlModel* model : all_models()) {
      ids.push_back(model->info().id);
    }
    return ids;
  });
}
