#pragma once

// Room `handbook`: the user's handbook. Pages of resources/handbook as HTML, and a search in them.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace feedscope {

struct HandbookPage {
  std::string name;   ///< file name without extension: "first-steps"
  std::string title;  ///< its first heading
  std::string markdown;
};

/// User's handbook in one language: pages of resources/handbook, in the order of the index.
class Handbook {
 public:
  /// `language`: "en", "fr"; English if there is no folder for it. Throws InputError if a page cannot be
  /// read.
  explicit Handbook(const std::string& language);

  /// The index first, then the pages in the order of its links.
  const std::vector<HandbookPage>& pages() const { return pages_; }
  /// Page with this name; nullptr if there is none.
  const HandbookPage* find(std::string_view name) const;
  /// Pages with every word of `words`, ignoring case; those with the exact phrase first.
  std::vector<const HandbookPage*> search(std::string_view words) const;

 private:
  void read(const std::filesystem::path& folder, const std::string& name);

  std::vector<HandbookPage> pages_;
};

/// Names of the pages linked from a page, in order, without repeats.
std::vector<std::string> linked_pages(const std::string& markdown);

/// HTML inside the body. Links to pages end with `ending`; headings have anchors as on GitHub.
std::string page_html(const HandbookPage& page, std::string_view ending);

/// A page as a complete file, with head, style and a link to the index; links lead to NAME.html. `language`:
/// of its text, "en", "fr".
std::string whole_page_html(const HandbookPage& page, std::string_view language);

}  // namespace feedscope
