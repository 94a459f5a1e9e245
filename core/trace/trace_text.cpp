#include "core/trace/trace_text.h"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "core/base/error.h"
#include "core/base/this_process.h"

namespace feedscope {
namespace {

constexpr std::size_t piece = 1U << 20U;  // bytes
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

struct TraceText::File {
  gzFile handle = nullptr;
  double size = 0;  ///< on disk [bytes]
};

TraceText::TraceText(const std::filesystem::path& file, Progress* progress)
    : name_(file.filename().string()), file_(std::make_unique<File>()), progress_(progress) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw InputError(message(NC_("core", "'{}' is a folder; give a trace"), file.string()));
  }
  errno = 0;
  file_->handle = gzdopen(descriptor_to_read(file), "rb");
  if (file_->handle == nullptr) {
    throw InputError(
        message(NC_("core", "cannot read trace '{}': {}"), file.string(),
                reason_of(std::error_code(errno == 0 ? ENOMEM : errno, std::generic_category()))));
  }
  const auto size = std::filesystem::file_size(file, error);
  file_->size = error ? 0 : static_cast<double>(size);
}

TraceText::TraceText(std::string_view text, std::string name) : name_(std::move(name)), memory_(text) {}

TraceText::~TraceText() {
  if (file_) {
    gzclose(file_->handle);
  }
}

bool TraceText::fill() {
  buffer_.erase(0, begin_);
  begin_ = 0;
  const std::size_t kept = buffer_.size();
  if (!file_) {
    const std::size_t more = std::min(piece, memory_.size());
    buffer_.append(memory_.substr(0, more));
    memory_.remove_prefix(more);
  } else {
    buffer_.resize(kept + piece);
    const int got = gzread(file_->handle, buffer_.data() + kept, static_cast<unsigned>(piece));
    if (got < 0) {
      int code = 0;
      const std::string_view text = gzerror(file_->handle, &code);  // "<fd:3>: invalid distance code"
      const std::size_t mark = text.starts_with("<fd:") ? text.find(": ") : std::string_view::npos;
      throw InputError(message(NC_("core", "cannot read trace '{}': {}"), name_,
                               text.substr(mark == std::string_view::npos ? 0 : mark + 2)));
    }
    buffer_.resize(kept + static_cast<std::size_t>(got));
    if (progress_ != nullptr && file_->size > 0) {
      progress_->report(std::min(1.0, static_cast<double>(gzoffset(file_->handle)) / file_->size));
    }
  }
  if (!started_) {
    started_ = true;
    begin_ = buffer_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    if (buffer_.starts_with("\xFF\xFE") || buffer_.starts_with("\xFE\xFF")) {
      throw InputError(message(NC_("core", "'{}' is written in UTF-16; save it as UTF-8"), name_));
    }
  }
  return buffer_.size() > kept;
}

std::string_view TraceText::head() {
  if (!started_) {
    fill();
  }
  return std::string_view(buffer_).substr(begin_);
}

bool TraceText::next_line(std::string_view& line) {
  head();
  auto end = buffer_.find('\n', begin_);
  while (end == std::string::npos) {
    const std::size_t looked_at = buffer_.size() - begin_;
    if (looked_at > piece) {
      throw InputError(
          message(NC_("core", "{}:{}: the line is longer than 1 MiB; this is not a table of samples"), name_,
                  line_ + 1));
    }
    if (!fill()) {
      break;
    }
    end = buffer_.find('\n', begin_ + looked_at);
  }
  const std::size_t size = (end == std::string::npos ? buffer_.size() : end) - begin_;
  if (end == std::string::npos && size == 0) {
    return false;
  }
  line = std::string_view(buffer_).substr(begin_, size);
  begin_ += size + (end == std::string::npos ? 0 : 1);
  if (line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  ++line_;
  return true;
}

std::string_view TraceText::next_piece() {
  if (started_ && begin_ >= buffer_.size()) {
    fill();
  }
  const std::string_view text = head();
  begin_ = buffer_.size();
  return text;
}

}  // namespace feedscope
