#include "core/base/markdown.h"

#include <cmark.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <memory>

namespace feedscope {
namespace {

constexpr std::string_view paragraph_begin = "<p>";
constexpr std::string_view paragraph_end = "</p>";

/// Removes the text up to and including `mark` from `rest` and returns it without `mark`.
std::string_view taken(std::string_view& rest, char mark) {
  const std::string_view piece = rest.substr(0, rest.find(mark));
  rest.remove_prefix(std::min(piece.size() + 1, rest.size()));
  return piece;
}

/// Converts "| a | b |" to a row of cells "th" or "td".
std::string table_row(std::string_view line, std::string_view cell) {
  taken(line, '|');
  std::string row = "<tr>";
  while (line.find('|') != line.npos) {
    row.append("<").append(cell).append(" align=\"left\">").append(taken(line, '|'));
    row.append("</").append(cell).append(">");
  }
  return row + "</tr>\n";
}

/// Converts a paragraph with bars to a table; empty unless its second line is a rule.
std::string table_of(std::string_view lines) {
  const std::string_view headings = taken(lines, '\n');
  const std::string_view rule = taken(lines, '\n');
  if (!rule.starts_with("|-") || rule.find_first_not_of("|- ") != rule.npos) {
    return {};
  }
  std::string table =
      "<table border=\"1\" cellspacing=\"0\" cellpadding=\"4\">\n" + table_row(headings, "th");
  while (!lines.empty()) {
    table += table_row(taken(lines, '\n'), "td");
  }
  return table + "</table>";
}

/// Converts tables, which CommonMark lacks: cmark leaves them as paragraphs, with the markup in their cells
/// converted.
std::string with_tables(const std::string& html) {
  std::string result;
  std::size_t from = 0;
  for (std::size_t at = 0; (at = html.find("<p>|", from)) != html.npos;) {
    const std::size_t end = html.find(paragraph_end, at);
    const std::size_t inside = at + paragraph_begin.size();
    const std::string table = table_of(std::string_view(html).substr(inside, end - inside));
    result.append(html, from, at - from);
    from = end + paragraph_end.size();
    result.append(table.empty() ? html.substr(at, from - at) : table);
  }
  return result.append(html, from);
}

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Whether a symbol of one letter with an index of one, "K_v", is at `at`.
bool has_symbol(std::string_view text, std::size_t at) {
  const auto is_word = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
  };
  return at + 2 < text.size() && is_letter(text[at]) && text[at + 1] == '_' && is_letter(text[at + 2]) &&
         !(at > 0 && is_word(at - 1)) && !is_word(at + 3);
}

/// Indices of symbols set low, but not in tags and code.
std::string with_low_indices(std::string_view html) {
  std::string result;
  bool in_code = false;
  for (std::size_t at = 0; at < html.size(); ++at) {
    if (html[at] == '<') {
      const std::string_view tag = html.substr(at, html.find('>', at) - at);
      in_code = tag.starts_with("<code") || (in_code && tag != "</code");
      result.append(tag);
      at += tag.size();
    }
    if (at < html.size() && !in_code && has_symbol(html, at)) {
      result.append(1, html[at]).append("<sub>").append(1, html[at + 2]).append("</sub>");
      at += 2;
    } else if (at < html.size()) {
      result += html[at];
    }
  }
  return result;
}

}  // namespace

std::string markdown_as_html(std::string_view markdown) {
  const std::unique_ptr<char, void (*)(void*)> html(
      cmark_markdown_to_html(markdown.data(), markdown.size(), CMARK_OPT_DEFAULT), std::free);
  return with_tables(with_low_indices(html.get()));
}

}  // namespace feedscope
