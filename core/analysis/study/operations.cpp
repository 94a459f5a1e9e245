#include "core/analysis/study/operations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <set>

#include "core/analysis/contour/contour_errors.h"
#include "core/analysis/study/heading.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

/// A line from which on another tool is in use.
struct ToolLine {
  std::uint32_t line;
  std::string tool;
};

/// Lines where M6 loads the tool requested last; in a program without M6, where a tool is requested.
std::vector<ToolLine> tool_lines(const Program& program) {
  std::vector<ToolLine> asked;
  std::vector<ToolLine> in;
  std::string next;
  for (std::uint32_t line = 1; line <= program.source->line_count(); ++line) {
    const ToolWords words = tool_words(program.source->utf8_line(line));
    const bool known =
        std::ranges::any_of(program.tools, [&](const ToolChange& tool) { return tool.name == words.tool; });
    if (known) {
      next = words.tool;
      asked.push_back({line, next});
    }
    if (words.comes_in && !next.empty()) {
      in.push_back({line, next});
    }
  }
  return in.empty() ? asked : in;
}

std::vector<Operation> by_tool(const Program& program, const Toolpath& path) {
  const std::vector<ToolLine> lines = tool_lines(program);
  std::vector<Operation> operations{{before_first_tool, 0, 0, 0}};
  std::string tool;
  for (std::uint32_t i = 0; i < path.segments.size(); ++i) {
    const auto after = std::ranges::upper_bound(lines, path.segments[i].line, {}, &ToolLine::line);
    if (after != lines.begin() && std::prev(after)->tool != tool) {
      tool = std::prev(after)->tool;
      operations.push_back({fmt::format("tool {}", tool), 0, i, 0});
    }
  }
  return operations;
}

/// A line with a heading, and its text.
struct Heading {
  std::uint32_t line;
  std::string title;
  bool closes = false;  ///< the text ends what an earlier heading began: "-- pocket 2 end --"
};

/// Text before the word "end" at the end of a title; "" without it.
std::string what_ends(const std::string& title) {
  std::size_t end = title.size();
  while (end > 0 && std::isalnum(static_cast<unsigned char>(title[end - 1])) == 0) {
    --end;
  }
  constexpr std::string_view word = " end";
  const bool says_so =
      end > word.size() &&
      std::equal(word.begin(), word.end(), title.begin() + static_cast<std::ptrdiff_t>(end - word.size()),
                 [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
  return says_so ? title.substr(0, end - word.size()) : std::string();
}

std::vector<Heading> headings_of(const SourceText& text) {
  std::vector<Heading> headings;
  std::set<std::string> before;
  for (std::uint32_t line = 1; line <= text.line_count(); ++line) {
    if (std::optional<std::string> title = operation_heading(text.utf8_line(line))) {
      const std::string ended = what_ends(*title);
      const auto heads = ended.empty() ? before.end() : before.lower_bound(ended);
      headings.push_back({line, *title, heads != before.end() && heads->starts_with(ended)});
      before.insert(std::move(*title));
    }
  }
  return headings;
}

/// Title from the comments in (last_line_before, line): in the last run, the first with a letter that does
/// not only end something.
const Heading* title_between(const std::vector<Heading>& headings, std::uint32_t after,
                             std::uint32_t before) {
  const auto end = std::ranges::lower_bound(headings, before, {}, &Heading::line);
  const Heading* title = nullptr;
  for (auto it = end; it != headings.begin();) {
    --it;
    if (it->line <= after || (title != nullptr && std::next(it)->line != it->line + 1)) {
      break;
    }
    if (title == nullptr || (!it->title.empty() && !it->closes) || title->closes) {
      title = &*it;
    }
  }
  return title;
}

std::vector<Operation> by_comment(const Program& program, const Toolpath& path) {
  const std::vector<Heading> headings = headings_of(*program.source);
  std::vector<Operation> operations{{before_first_tool, 0, 0, 0}};
  std::uint32_t before = 0;
  for (std::uint32_t i = 0; i < path.segments.size(); ++i) {
    const std::uint32_t line = path.segments[i].line;
    if (line == before) {
      continue;
    }
    const bool goes_back = line < before;  // a loop, or a call that returns
    const Heading* title = title_between(headings, goes_back ? 0 : before, line);
    const bool goes_on = goes_back && title != nullptr && title->line == operations.back().line;
    if (title != nullptr && !goes_on) {
      operations.push_back({title->title.empty() || title->closes ? title_of_line(title->line) : title->title,
                            title->line, i, 0});
    }
    before = line;
  }
  return operations;
}

/// Index of the largest time; the last cause if there is none.
std::size_t largest_of(const std::vector<double>& times) {
  return static_cast<std::size_t>(std::ranges::max_element(times) - times.begin());
}

}  // namespace

std::string title_of_line(std::uint32_t line) {
  return fmt::format("line {}", line);
}

OperationSplit operation_split(const std::string& name) {
  if (name == "tool") {
    return OperationSplit::tool;
  }
  if (name == "comment") {
    return OperationSplit::comment;
  }
  const std::string near = nearest_name(name, {"tool", "comment"});
  throw InputError(fmt::format("operations cannot be grouped by '{}'; {}choose tool or comment", name,
                               near.empty() ? "" : fmt::format("did you mean '{}'? ", near)));
}

std::vector<Operation> split_operations(const Program& program, const Toolpath& path, OperationSplit split) {
  if (split == OperationSplit::none) {
    return {};
  }
  std::vector<Operation> operations =
      split == OperationSplit::tool ? by_tool(program, path) : by_comment(program, path);
  const auto end = static_cast<std::uint32_t>(path.segments.size());
  for (std::size_t i = 0; i < operations.size(); ++i) {
    operations[i].last = i + 1 < operations.size() ? operations[i + 1].first : end;
    if (operations[i].line == 0 && operations[i].first < end) {
      operations[i].line = path.segments[operations[i].first].line;
    }
  }
  std::erase_if(operations, [](const Operation& operation) { return operation.first >= operation.last; });
  return operations;
}

std::vector<OperationFigures> figures_of(const std::vector<Operation>& operations,
                                         const Trajectory& trajectory) {
  std::vector<OperationFigures> figures(operations.size());
  std::vector<std::vector<double>> by_cause(operations.size(), std::vector<double>(all_causes().size(), 0.0));
  std::vector<std::uint32_t> first_element(operations.size() + 1,
                                           static_cast<std::uint32_t>(trajectory.path().size()));
  std::size_t of = 0;
  for (std::uint32_t element = 0; element < trajectory.path().size(); ++element) {
    const std::uint32_t segment = trajectory.path().segment(element);
    while (of < operations.size() && operations[of].first <= segment) {
      first_element[of++] = element;
    }
  }
  of = 0;
  const BlendedPath& path = trajectory.path();
  for (PartWalk walk(trajectory); !walk.done() && !operations.empty(); walk.next()) {
    const Part& part = walk.part();
    while (of + 1 < operations.size() && first_element[of + 1] <= part.element) {
      ++of;
    }
    figures[of].time += part.duration;
    by_cause[of][cause_index(limiting_cause(trajectory, part))] += part.duration;
    if (!trajectory.is_rapid(part.element) && path.kind(part.element) != ElementKind::dwell) {
      figures[of].cutting_time += part.duration;
    }
  }
  for (std::size_t i = 0; i < operations.size(); ++i) {
    for (std::uint32_t element = first_element[i]; element < first_element[i + 1]; ++element) {
      figures[i].cutting_length += trajectory.is_rapid(element) ? 0 : path.length(element);
    }
    const std::size_t cause = largest_of(by_cause[i]);
    figures[i].cause = all_causes()[cause];
    figures[i].cause_time = by_cause[i][cause];
    const ContourRequest request{1, ContourBins::none, first_element[i], first_element[i + 1]};
    const ContourErrors errors = contour_errors(trajectory, request);
    figures[i].contour_error = errors.largest;
    figures[i].cutting_contour_error = cutting_contour_error(trajectory, errors, request);
  }
  return figures;
}

std::vector<CauseShare> limiting_causes(const Summary& summary) {
  std::vector<CauseShare> shares;
  for (std::size_t i = 0; i < summary.time_by_cause.size(); ++i) {
    const bool slows = all_causes()[i].kind == CauseKind::ramp_down;
    const double own = slows ? 0 : summary.time_by_cause[i];
    const double ahead = i < summary.time_by_slower_place.size() ? summary.time_by_slower_place[i] : 0;
    if (own + ahead > 0) {
      shares.push_back({all_causes()[i], (own + ahead) / summary.cycle_time});
    }
  }
  std::ranges::stable_sort(shares, std::greater(), &CauseShare::share);
  return shares;
}

}  // namespace feedscope
