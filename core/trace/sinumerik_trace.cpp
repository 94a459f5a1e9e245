#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "core/base/error.h"
#include "core/trace/channel_titles.h"
#include "core/trace/trace_formats.h"
#include "core/trace/trace_row.h"

namespace feedscope {
namespace {

constexpr double not_a_value = 9.2e18;  // bits of a missing 64-bit number, written as a whole number

// Expat 2.9 deprecates the functions whose width depends on the build.
#if XML_MAJOR_VERSION > 2 || (XML_MAJOR_VERSION == 2 && XML_MINOR_VERSION >= 9)
std::uint64_t current_line(XML_Parser parser) {
  return XML_GetCurrentLineNumber64(parser);
}
#else
std::uint64_t current_line(XML_Parser parser) {
  return XML_GetCurrentLineNumber(parser);
}
#endif

using Attributes = std::map<std::string, std::string, std::less<>>;

std::string attribute(const Attributes& attributes, std::string_view name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? "" : found->second;
}

/// Processes the elements of a file in order.
class SinumerikReader {
 public:
  SinumerikReader(TraceText& text, const TraceColumns& asked)
      : text_(text),
        asked_(asked),
        builder_(text.name(), "SINUMERIK trace"),
        parser_(XML_ParserCreate(nullptr), XML_ParserFree) {
    if (parser_ == nullptr) {
      throw std::bad_alloc();
    }
    XML_SetUserData(parser_.get(), this);
    XML_SetStartElementHandler(parser_.get(), &SinumerikReader::start);
  }

  Trace read() {
    bool whole = true;
    for (std::string_view piece = text_.next_piece(); !piece.empty() && whole; piece = text_.next_piece()) {
      whole = parse(piece, false);
    }
    if (whole) {
      parse({}, true);
    }
    if (error_) {
      std::rethrow_exception(error_);
    }
    if (!used_) {
      throw InputError(message(NC_("core", "'{}' has no record of a SINUMERIK trace"), text_.name()));
    }
    return builder_.finish();
  }

 private:
  /// Returns false if parsing cannot continue.
  bool parse(std::string_view piece, bool last) {
    if (XML_Parse(parser_.get(), piece.data(), static_cast<int>(piece.size()), last ? 1 : 0) ==
            XML_STATUS_ERROR &&
        !error_) {
      if (used_) {  // a truncated file: the samples so far count
        builder_.note(Severity::warning, line(), "trace-xml",
                      message(NC_("core", "the XML ends early: {}"),
                              std::string_view(XML_ErrorString(XML_GetErrorCode(parser_.get())))),
                      NC_("core", "the records before it are used"));
        return false;
      }
      throw InputError(message(NC_("core", "{}:{}: {}; this is no whole XML file"), text_.name(), line(),
                               std::string_view(XML_ErrorString(XML_GetErrorCode(parser_.get())))));
    }
    return !error_;
  }
  std::uint32_t line() const { return static_cast<std::uint32_t>(current_line(parser_.get())); }

  static void XMLCALL start(void* self, const XML_Char* name, const XML_Char** attributes) {
    auto& reader = *static_cast<SinumerikReader*>(self);
    try {
      reader.element(name, attributes);
    } catch (...) {  // not through the parser, which is C
      reader.error_ = std::current_exception();
      XML_StopParser(reader.parser_.get(), XML_FALSE);
    }
  }

  void element(std::string_view name, const XML_Char** attributes) {
    if (name == "rec") {
      record(attributes);
      return;
    }
    if (name != "signal" && name != "dataSignal") {
      return;
    }
    Attributes all;
    for (const XML_Char** a = attributes; *a != nullptr; a += 2) {
      all.emplace(a[0], a[1]);
    }
    const std::string title = attribute(all, "description") + " " + attribute(all, "name");
    if (name == "signal") {
      signals_[attribute(all, "key")] = title;
      return;
    }
    if (used_) {
      return;  // of another frame
    }
    const std::string key = attribute(all, "key");
    const auto known = signals_.find(key);
    std::string id = attribute(all, "id");
    if (id.empty()) {
      id = fmt::format("f{}", fields_.size() + 1);
    }
    fields_.push_back(id);
    titles_.push_back(title.size() > 1 || known == signals_.end() ? title : known->second);
  }

  void begin_records() {
    used_ = used_channels(titles_, asked_, text_.name(), builder_);
    for (const UsedChannel& channel : *used_) {
      names_.push_back(fields_[channel.channel.place]);
    }
  }

  void record(const XML_Char** attributes) {
    if (!used_) {
      begin_records();
    }
    TraceSample sample;
    for (const XML_Char** a = attributes; *a != nullptr; a += 2) {
      const std::string_view name = a[0];
      const auto number = field_number(a[1], '.');
      if (!number || *number > not_a_value) {
        continue;
      }
      if (name == "time") {
        sample.time = *number;
        continue;
      }
      for (std::size_t c = 0; c < names_.size(); ++c) {
        if (name == names_[c]) {
          sample.set((*used_)[c].quantity, (*used_)[c].channel.inside(*number));
        }
      }
    }
    builder_.add(sample, line());
  }

  TraceText& text_;
  const TraceColumns& asked_;
  TraceBuilder builder_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::exception_ptr error_;
  Attributes signals_;               ///< title by key
  std::vector<std::string> fields_;  ///< attribute of `rec` per signal
  std::vector<std::string> titles_;
  std::optional<std::vector<UsedChannel>> used_;
  std::vector<std::string> names_;  ///< attributes of the used signals
};

}  // namespace

bool is_sinumerik_trace(std::string_view head) {
  const auto first = head.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && head[first] == '<';
}

Trace read_sinumerik_trace(TraceText& text, const TraceColumns& columns) {
  return SinumerikReader(text, columns).read();
}

}  // namespace feedscope
