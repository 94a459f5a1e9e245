#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace feedscope {

struct HandbookPage {
  std::string name;   ///< of its file without ending: "first-steps"
  std::string title;  ///< its first heading
  std::string markdown;
};

/// The user's handbook in one language: pages of resources/handbook, in the order of the index.
class Handbook {
 public:
  /// `language`: "en", "fr"; English where there is no folder for it. Throws InputError if a page cannot be
  /// read.
  explicit Handbook(const std::string& language);

  /// The index first, then the pages in the order in which it links them.
  const std::vector<HandbookPage>& pages() const { return pages_; }
  /// nullptr for a name that no page has.
  const HandbookPage* find(std::string_view name) const;
  /// Pages that hold every word of `words`, upper and lower case being the same; those that hold them as they
  /// stand first.
  std::vector<const HandbookPage*> search(std::string_view words) const;

 private:
  void read(const std::filesystem::path& folder, const std::string& name);

  std::vector<HandbookPage> pages_;
};

/// Names of the pages that the links of a page lead to, in written order, without repeats.
std::vector<std::string> linked_pages(const std::string& markdown);

/// The inside of a body. Links to pages end with `ending`; headings have anchors, as GitHub makes them.
std::string page_html(const HandbookPage& page, std::string_view ending);

/// A page as a file of its own, with head, style and the way back to the index; links lead to NAME.html.
/// `language` is that of its text: "en", "fr".
std::string whole_page_html(const HandbookPage& page, std::string_view language);

}  // namespace feedscope
