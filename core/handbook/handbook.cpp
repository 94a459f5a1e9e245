#include "core/handbook/handbook.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>

#include "core/base/data_folder.h"
#include "core/base/error.h"
#include "core/base/markdown.h"
#include "core/program/text/message_codes.h"

namespace feedscope {
namespace {

constexpr std::string_view style =
    "body { font-family: \"DejaVu Sans\", \"Noto Sans\", Arial, sans-serif; font-size: 15px; line-height: "
    "1.5; "
    "color: #1a1a1a; max-width: 760px; margin: 24px auto; padding: 0 16px; }\n"
    "h1 { font-size: 26px; } h2 { font-size: 20px; margin-top: 28px; } h3 { font-size: 16px; }\n"
    "pre { background: #f1f3f5; padding: 10px 12px; overflow-x: auto; line-height: 1.35; }\n"
    "code { font-family: \"DejaVu Sans Mono\", monospace; font-size: 13px; }\n"
    "a { color: #1f5fa8; } li { margin: 3px 0; }\n"
    "table { border-collapse: collapse; } th, td { padding: 4px 8px; vertical-align: top; }\n"
    "nav { font-size: 13px; border-bottom: 1px solid #c8ccd0; padding-bottom: 8px; }\n";

/// Placeholder for the list of all messages.
constexpr std::string_view all_message_codes = "{all message codes}\n";

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) {
    return c < 0x80 ? static_cast<char>(std::tolower(c)) : static_cast<char>(c);
  });
  return lower;
}

std::string title_of(const std::string& markdown) {
  static const std::regex heading(R"(^# +([^\n]+))", std::regex::multiline);
  std::smatch match;
  return std::regex_search(markdown, match, heading) ? match[1].str() : "";
}

/// Anchor of a heading: "Times and positions" is "times-and-positions"; of other characters only letters
/// beyond ASCII are kept, not the typographic apostrophe.
std::string anchor_of(const std::string& heading) {
  static const std::regex markup("<[^>]*>|&[a-z]+;|\u2019");
  std::string anchor;
  for (const char c : lower_case(std::regex_replace(heading, markup, ""))) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || byte >= 0x80 || c == '-' || c == '_') {
      anchor += c;
    } else if (c == ' ') {
      anchor += '-';
    }
  }
  return anchor;
}

std::string with_anchors(const std::string& html) {
  static const std::regex heading("<h([1-6])>(.*?)</h[1-6]>");
  std::string result;
  auto from = html.begin();
  for (auto match = std::sregex_iterator(html.begin(), html.end(), heading); match != std::sregex_iterator();
       ++match) {
    result.append(from, (*match)[0].first);
    result += fmt::format("<h{0} id=\"{2}\"><a name=\"{2}\"></a>{1}</h{0}>", (*match)[1].str(),
                          (*match)[2].str(), anchor_of((*match)[2].str()));
    from = (*match)[0].second;
  }
  return result.append(from, html.end());
}

}  // namespace

Handbook::Handbook(const std::string& language) {
  const std::filesystem::path all = data_folder() / "resources" / "handbook";
  const bool exists = !language.empty() && std::filesystem::is_directory(all / language);
  const std::filesystem::path folder = all / (exists ? language : "en");
  read(folder, "index");
  for (const std::string& name : linked_pages(pages_.front().markdown)) {
    if (find(name) == nullptr) {
      read(folder, name);
    }
  }
}

void Handbook::read(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path file = folder / (name + ".md");
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw InputError(
        fmt::format("{}: this page of the handbook cannot be read; install Feedscope again", file.string()));
  }
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (const std::size_t codes = text.find(all_message_codes); codes != std::string::npos) {
    text.replace(codes, all_message_codes.size(), message_code_lists());
  }
  std::string title = title_of(text);
  pages_.push_back({name, std::move(title), std::move(text)});
}

const HandbookPage* Handbook::find(std::string_view name) const {
  const auto found = std::ranges::find(pages_, name, &HandbookPage::name);
  return found == pages_.end() ? nullptr : &*found;
}

std::vector<const HandbookPage*> Handbook::search(std::string_view words) const {
  std::vector<std::string> wanted;
  const std::string lower = lower_case(words);
  for (std::size_t at = 0; (at = lower.find_first_not_of(' ', at)) != std::string::npos;) {
    const std::size_t end = std::min(lower.find(' ', at), lower.size());
    wanted.push_back(lower.substr(at, end - at));
    at = end;
  }
  std::vector<const HandbookPage*> found;
  for (const HandbookPage& page : pages_) {
    const std::string text = lower_case(page.markdown);
    if (std::ranges::all_of(wanted, [&](const std::string& word) { return text.find(word) != text.npos; })) {
      found.push_back(&page);
    }
  }
  std::stable_partition(found.begin(), found.end(), [&](const HandbookPage* page) {
    return wanted.size() > 1 && lower_case(page->markdown).find(lower) != std::string::npos;
  });
  return found;
}

std::vector<std::string> linked_pages(const std::string& markdown) {
  static const std::regex link(R"(\]\(([a-z0-9-]+)\.md(?:#[^)]*)?\))");
  std::vector<std::string> names;
  for (auto match = std::sregex_iterator(markdown.begin(), markdown.end(), link);
       match != std::sregex_iterator(); ++match) {
    const std::string name = (*match)[1].str();
    if (std::ranges::find(names, name) == names.end()) {
      names.push_back(name);
    }
  }
  return names;
}

std::string page_html(const HandbookPage& page, std::string_view ending) {
  static const std::regex link(R"re(href="([a-z0-9-]+)\.md(#[^"]*)?")re");
  return with_anchors(
      std::regex_replace(markdown_as_html(page.markdown), link, fmt::format("href=\"$1{}$2\"", ending)));
}

std::string whole_page_html(const HandbookPage& page, std::string_view language) {
  const std::string_view up = page.name == "index" ? "" : "<nav><a href=\"index.html\">Feedscope</a></nav>\n";
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n"
      "<style>\n{}</style>\n</head>\n<body>\n{}{}</body>\n</html>\n",
      language, page.title, style, up, page_html(page, ".html"));
}

}  // namespace feedscope
