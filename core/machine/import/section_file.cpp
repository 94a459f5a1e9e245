#include "core/machine/import/section_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/machine/file_text.h"

namespace feedscope {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_included = 4;  // MiB
constexpr std::size_t most_files = 200;
constexpr std::size_t deepest = 16;
constexpr std::string_view saved_mark = "#*#";  // Klipper's own part at the end of printer.cfg

bool has_wildcards(const std::string& pattern) {
  return pattern.find_first_of("*?[") != std::string::npos;
}

/// Removes the first element of a pattern, a character, `?` or a set such as `[a-z]` or `[!0-9]`; returns
/// whether `c` matches it.
bool match_element(std::string_view& pattern, char c) {
  const std::size_t end =
      pattern.front() == '[' ? pattern.find(']', pattern.starts_with("[!") ? 3 : 2) : std::string_view::npos;
  if (end == std::string_view::npos) {
    const char own = pattern.front();
    pattern.remove_prefix(1);
    return own == '?' || own == c;
  }
  std::string_view set = pattern.substr(1, end - 1);
  pattern.remove_prefix(end + 1);
  const bool inverted = set.front() == '!';
  set.remove_prefix(inverted ? 1 : 0);
  bool inside = false;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const bool range = i + 2 < set.size() && set[i + 1] == '-';
    inside = inside || (set[i] <= c && c <= set[range ? i + 2 : i]);
    i += range ? 2 : 0;
  }
  return inside != inverted;
}

/// Whether a file's name matches a pattern, as for Klipper: a hidden file does only if the pattern begins
/// with its point.
bool matches(std::string_view pattern, std::string_view name) {
  if (name.starts_with('.') && !pattern.starts_with('.')) {
    return false;
  }
  std::string_view after_star;
  std::optional<std::string_view> retry;  // the part of the name that the latest star has not taken
  while (!name.empty()) {
    if (pattern.starts_with('*')) {
      pattern.remove_prefix(1);
      after_star = pattern;
      retry = name;
    } else if (!pattern.empty() && match_element(pattern, name.front())) {
      name.remove_prefix(1);
    } else if (retry) {
      retry->remove_prefix(1);
      name = *retry;
      pattern = after_star;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*') == std::string_view::npos;
}

/// Files that match the last part of a pattern, sorted.
std::vector<fs::path> matching_files(const fs::path& pattern) {
  std::vector<fs::path> files;
  const std::string name = pattern.filename().string();
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(pattern.parent_path(), ignored)) {
    if (matches(name, entry.path().filename().string())) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

GivenValue SectionEntry::given(std::string_view unit) const {
  return {place, fmt::format("[{}] {} = {}{}{}", section, key, value, unit.empty() ? "" : " ", unit)};
}

SectionFile::SectionFile(const ConfigurationSource& source, SectionStyle style, MachineDraft& draft)
    : style_(style), draft_(draft) {
  read(source.text, {"", source.folder});
}

void SectionFile::leave_out_rest() const {
  for (const SectionEntry& entry : entries_) {
    const bool reads_section =
        std::ranges::any_of(asked_, [&](const auto& asked) { return asked.first == entry.section; });
    if (!reads_section) {
      draft_.leave_out(fmt::format("[{}]", entry.section));
    } else if (!asked_.contains({entry.section, entry.key})) {
      draft_.leave_out(fmt::format("[{}] {}", entry.section, entry.key));
    }
  }
}

const SectionEntry* SectionFile::find(std::string_view section, std::string_view key) {
  const auto found = holding_.find(*asked_.insert({std::string(section), std::string(key)}).first);
  return found == holding_.end() ? nullptr : &entries_[found->second];
}

const SectionHead* SectionFile::find_section(std::string_view section) const {
  const auto found = std::ranges::find(sections_, section, &SectionHead::name);
  return found == sections_.end() ? nullptr : &*found;
}

ConfigurationPlace SectionFile::place_of(std::string_view section) const {
  const SectionHead* head = find_section(section);
  return head == nullptr ? ConfigurationPlace() : head->place;
}

std::string_view SectionFile::without_comment(std::string_view text) const {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool mark = text[i] == '#' || text[i] == ';';
    if (mark && (i == 0 || style_ == SectionStyle::klipper || text[i - 1] == ' ' || text[i - 1] == '\t')) {
      return without_blanks(text.substr(0, i));
    }
  }
  return text;
}

void SectionFile::read(std::string_view text, const OpenFile& file) {
  ++files_;
  for (const ConfigurationLine& line : lines_of(text)) {
    if (!include(line, file)) {
      read_line(line, file);
    }
  }
}

void SectionFile::read_line(const ConfigurationLine& line, const OpenFile& file) {
  std::string_view text = line.text;
  if (style_ == SectionStyle::klipper && text.starts_with(saved_mark)) {
    text = without_blanks(text.substr(saved_mark.size()));
  } else if (line.indented && style_ == SectionStyle::klipper) {
    return;  // it continues the value above, like the commands of a macro
  }
  text = without_comment(text);
  const ConfigurationPlace place{line.number, file.name};
  if (text.empty()) {
    return;
  }
  if (text.front() == '[' && text.back() == ']') {
    section_ = without_blanks(text.substr(1, text.size() - 2));
    sections_.push_back({section_, place});
    return;
  }
  const std::size_t sign = text.find_first_of(style_ == SectionStyle::klipper ? ":=" : "=");
  if (sign == std::string_view::npos || sign == 0 || text.front() == '[') {
    draft_.note(Severity::warning, place, "not-understood",
                message(NC_("core", "'{}' is neither a section nor a value; skipped"), text));
    return;
  }
  add({section_, std::string(without_blanks(text.substr(0, sign))),
       std::string(without_blanks(text.substr(sign + 1))), place});
}

void SectionFile::add(SectionEntry entry) {
  const auto before = holding_.find({entry.section, entry.key});
  const SectionEntry* other = before == holding_.end() ? nullptr : &entries_[before->second];
  const bool takes_part = entry.key.starts_with("MAX_") || entry.key.starts_with("max_") ||
                          entry.key == "LINEAR_UNITS" || entry.section == "printer";
  if (other != nullptr && takes_part && other->value != entry.value) {
    const bool first_holds = style_ == SectionStyle::linuxcnc;
    draft_.note(
        Severity::warning, entry.place, "given-twice",
        message(NC_("core", "[{}] {} = {}, but {} in {}; {} is used"), entry.section, entry.key, entry.value,
                other->value, draft_.place_text(other->place), first_holds ? other->value : entry.value),
        NC_("core", "remove one of the two"));
  }
  if (other == nullptr || style_ == SectionStyle::klipper) {
    holding_[{entry.section, entry.key}] = entries_.size();
  }
  entries_.push_back(std::move(entry));
}

bool SectionFile::include(const ConfigurationLine& line, const OpenFile& file) {
  constexpr std::string_view linuxcnc_word = "#INCLUDE";
  constexpr std::string_view klipper_word = "[include ";
  const ConfigurationPlace place{line.number, file.name};
  if (style_ == SectionStyle::linuxcnc && in_upper_case(line.text).starts_with(linuxcnc_word)) {
    include_all(std::string(without_blanks(line.text.substr(linuxcnc_word.size()))), place, file);
    return true;
  }
  const std::string_view text = without_comment(line.text);
  if (style_ == SectionStyle::klipper && text.starts_with(klipper_word) && text.back() == ']') {
    const std::string_view inside = text.substr(klipper_word.size());
    include_all(std::string(without_blanks(inside.substr(0, inside.size() - 1))), place, file);
    return true;
  }
  return false;
}

void SectionFile::include_all(const std::string& pattern, const ConfigurationPlace& place,
                              const OpenFile& from) {
  if (from.folder.empty() || pattern.empty()) {
    draft_.note(Severity::error, place, "not-included",
                message(NC_("core", "'{}' cannot be included: {}"), pattern,
                        pattern.empty() ? NC_("core", "no file is named")
                                        : NC_("core", "only the text itself is at hand")),
                NC_("core", "values that stand there are missing here"));
    return;
  }
  const fs::path path = from.folder / pattern;
  const fs::path beside = fs::path(from.name).parent_path();
  if (style_ == SectionStyle::linuxcnc || !has_wildcards(pattern)) {
    include_one(path, (beside / pattern).generic_string(), place);
    return;
  }
  for (const fs::path& file : matching_files(path)) {
    include_one(file, (beside / fs::path(pattern).parent_path() / file.filename()).generic_string(), place);
  }
}

void SectionFile::include_one(const fs::path& file, const std::string& name,
                              const ConfigurationPlace& place) {
  std::error_code ignored;
  const auto refuse = [&](const Message& reason) {
    draft_.note(Severity::error, place, "not-included",
                message(NC_("core", "'{}' cannot be included: {}"), name, reason),
                NC_("core", "values that stand there are missing here"));
  };
  if (std::ranges::any_of(open_, [&](const fs::path& one) { return fs::equivalent(one, file, ignored); })) {
    refuse(NC_("core", "it includes itself"));
  } else if (open_.size() >= deepest) {
    refuse(message(NC_("core", "more than {} files deep"), deepest));
  } else if (files_ >= most_files) {
    refuse(message(NC_("core", "more than {} files"), most_files));
  } else {
    try {
      const std::string text = utf8_text(file_text(file, NC_("core", "configuration"), largest_included));
      const std::string section = section_;
      open_.push_back(file);
      read(text, {name, file.parent_path()});
      open_.pop_back();
      section_ = section;
    } catch (const InputError& error) {
      refuse(error.message());
    }
  }
}

}  // namespace feedscope
