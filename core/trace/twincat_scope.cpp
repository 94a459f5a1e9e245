#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/trace/channel_merge.h"
#include "core/trace/channel_titles.h"
#include "core/trace/trace_formats.h"
#include "core/trace/trace_row.h"

namespace feedscope {
namespace {

constexpr double millisecond = 1e-3;
constexpr double tick = 1e-7;         // [s], unit of a FILETIME
constexpr double least_ticks = 1e15;  // for any time since 1604: times of this size are FILETIMEs

/// Rows of the header by their first field; cells before values repeat that word.
class ScopeHead {
 public:
  /// Whether the line belongs to the channel header.
  bool take(const std::vector<std::string_view>& fields) {
    if (fields.empty() || fields.front().empty() || field_number(fields.front(), '.') ||
        field_number(fields.front(), ',')) {
      return false;
    }
    const std::string key(fields.front());
    if (key == "Name" && fields.size() > 2) {
      names_.assign(fields.begin(), fields.end());
    } else if (!names_.empty()) {
      rows_[key].assign(fields.begin(), fields.end());
    }
    return true;
  }
  bool has_names() const { return !names_.empty(); }

  struct Channel {
    std::size_t column = 0;
    std::size_t time_column = 0;
    std::string title;
  };
  std::vector<Channel> channels() const {
    std::vector<Channel> channels;
    std::size_t time_column = 0;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (names_[i] == "Name") {
        time_column = i;
        continue;
      }
      std::string title = names_[i];
      const std::string symbol = cell("SymbolName", i);
      title += symbol.empty() || symbol == title ? "" : " " + symbol;
      std::string unit = cell("Unit", i);
      unit = unit.substr(0, unit.find(' '));
      title += unit.empty() || unit.starts_with('(') ? "" : fmt::format(" [{}]", unit);
      channels.push_back({i, time_column, title});
    }
    return channels;
  }

 private:
  std::string cell(const std::string& row, std::size_t i) const {
    const auto found = rows_.find(row);
    return found == rows_.end() || i >= found->second.size() ? "" : found->second[i];
  }

  std::vector<std::string> names_;
  std::map<std::string, std::vector<std::string>> rows_;
};

class ScopeReader {
 public:
  ScopeReader(TraceText& text, const TraceColumns& asked)
      : text_(text), asked_(asked), builder_(text.name(), "TwinCAT Scope") {}

  Trace read() {
    read_head();
    used_ = used_channels(titles(), asked_, text_.name(), builder_);
    channels_.resize(used_.size());
    for (std::size_t c = 0; c < used_.size(); ++c) {
      channels_[c].quantity = used_[c].quantity;
    }
    do {
      read_row();
    } while (text_.next_line(line_));
    add_channels(channels_, builder_);
    return builder_.finish();
  }

 private:
  /// Reads up to the first row of numbers, which is then `line_`.
  void read_head() {
    const std::string_view start = text_.head();
    const auto names = start.find("\nName");
    const char after = names == std::string_view::npos || names + 5 >= start.size() ? '\t' : start[names + 5];
    separator_ = asked_.separator != 0 ? asked_.separator : after == ';' || after == ',' ? after : '\t';
    while (text_.next_line(line_)) {
      split_row(line_, separator_, fields_);
      if (line_.empty() || head_.take(fields_)) {
        continue;
      }
      if (head_.has_names()) {
        decimal_ = asked_.decimal != 0                                               ? asked_.decimal
                   : separator_ != ',' && start.find('\t') != std::string_view::npos ? decimal_of(start)
                                                                                     : '.';
        head_channels_ = head_.channels();
        return;
      }
    }
    throw InputError(message(NC_("core", "{}:{}: no samples follow the head of the TwinCAT Scope export"),
                             text_.name(), text_.line_number()));
  }

  /// Decimal sign: a comma if one of the first rows has a number with one.
  char decimal_of(std::string_view start) const {
    const auto rows = start.find(line_);
    std::vector<std::string_view> fields;
    for (std::string_view rest = rows == std::string_view::npos ? line_ : start.substr(rows);
         !rest.empty();) {
      const auto end = rest.find('\n');
      split_row(rest.substr(0, end), separator_, fields);
      for (const std::string_view field : fields) {
        if (field.find(',') != std::string_view::npos && field_number(field, ',')) {
          return ',';
        }
      }
      rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    return '.';
  }

  std::vector<std::string> titles() const {
    std::vector<std::string> all;
    for (const ScopeHead::Channel& channel : head_channels_) {
      all.push_back(channel.title);
    }
    return all;
  }

  void read_row() {
    if (line_.empty() || line_ == "EOF") {
      return;
    }
    split_row(line_, separator_, fields_);
    bool any = false;
    for (std::size_t c = 0; c < used_.size(); ++c) {
      const ScopeHead::Channel& channel = head_channels_[used_[c].channel.place];
      if (channel.column >= fields_.size()) {
        continue;
      }
      const auto time = field_number(fields_[channel.time_column], decimal_);
      const auto value = field_number(fields_[channel.column], decimal_);
      if (time && value) {
        any = true;
        if (*time > least_ticks && first_ticks_ == 0) {
          first_ticks_ = *time;
        }
        channels_[c].time.push_back(first_ticks_ > 0 ? (*time - first_ticks_) * tick : *time * millisecond);
        channels_[c].value.push_back(used_[c].channel.inside(*value));
        channels_[c].line.push_back(text_.line_number());
      }
    }
    if (!any) {
      builder_.skip(text_.line_number(), line_);
    }
  }

  TraceText& text_;
  const TraceColumns& asked_;
  TraceBuilder builder_;
  ScopeHead head_;
  std::vector<ScopeHead::Channel> head_channels_;
  std::vector<UsedChannel> used_;
  std::vector<TraceChannel> channels_;
  std::string_view line_;
  std::vector<std::string_view> fields_;
  char separator_ = '\t';
  char decimal_ = '.';
  double first_ticks_ = 0;
};

}  // namespace

bool is_twincat_scope(std::string_view head) {
  return head.starts_with("Name") &&
         head.substr(0, head.size()).find("SampleTime[ms]") != std::string_view::npos;
}

Trace read_twincat_scope(TraceText& text, const TraceColumns& columns) {
  return ScopeReader(text, columns).read();
}

}  // namespace feedscope
