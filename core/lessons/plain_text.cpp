#include "core/lessons/plain_text.h"

#include <cmark.h>

#include <memory>
#include <sstream>

namespace feedscope {
namespace {

std::string literal_of(cmark_node* node) {
  const char* literal = cmark_node_get_literal(node);
  return literal == nullptr ? "" : literal;
}

/// Text inside a paragraph or a heading.
std::string inline_text(cmark_node* node) {
  std::string text;
  for (cmark_node* child = cmark_node_first_child(node); child != nullptr; child = cmark_node_next(child)) {
    const cmark_node_type type = cmark_node_get_type(child);
    const bool breaks = type == CMARK_NODE_SOFTBREAK || type == CMARK_NODE_LINEBREAK;
    text += breaks ? " " : literal_of(child) + inline_text(child);
  }
  return text;
}

class BlockReader {
 public:
  void read(cmark_node* parent, std::size_t indent) {
    for (cmark_node* node = cmark_node_first_child(parent); node != nullptr; node = cmark_node_next(node)) {
      switch (cmark_node_get_type(node)) {
        case CMARK_NODE_LIST:
          read_list(node, indent);
          break;
        case CMARK_NODE_CODE_BLOCK:
          add_code(literal_of(node), indent);
          break;
        case CMARK_NODE_PARAGRAPH:
        case CMARK_NODE_HEADING:
        case CMARK_NODE_HTML_BLOCK:
          add({marker_, indent, inline_text(node) + literal_of(node), false, in_list_});
          break;
        default:
          read(node, indent);
      }
    }
  }

  std::vector<PlainBlock> blocks;

 private:
  void add(PlainBlock block) {
    blocks.push_back(std::move(block));
    marker_.clear();
    in_list_ = false;
  }

  void read_list(cmark_node* list, std::size_t indent) {
    const bool tight = cmark_node_get_list_tight(list) != 0;
    const bool numbered = cmark_node_get_list_type(list) == CMARK_ORDERED_LIST;
    int number = cmark_node_get_list_start(list);
    bool first = true;
    for (cmark_node* item = cmark_node_first_child(list); item != nullptr; item = cmark_node_next(item)) {
      marker_ = numbered ? std::to_string(number++) + ". " : "- ";
      in_list_ = tight && !first;
      first = false;
      read(item, indent + marker_.size());
    }
  }

  void add_code(const std::string& code, std::size_t indent) {
    std::istringstream lines(code);
    bool follows = false;
    for (std::string line; std::getline(lines, line);) {
      add({marker_, indent, line, true, follows});
      follows = true;
    }
  }

  std::string marker_;    ///< of the next item
  bool in_list_ = false;  ///< the next item directly follows another
};

}  // namespace

std::vector<PlainBlock> plain_blocks(const std::string& markdown) {
  const std::unique_ptr<cmark_node, void (*)(cmark_node*)> document(
      cmark_parse_document(markdown.data(), markdown.size(), CMARK_OPT_DEFAULT), cmark_node_free);
  BlockReader reader;
  reader.read(document.get(), 0);
  return std::move(reader.blocks);
}

std::string plain_line(const std::string& markdown) {
  std::string line;
  for (const PlainBlock& block : plain_blocks(markdown)) {
    line += (line.empty() ? "" : " ") + block.marker + block.text;
  }
  return line;
}

}  // namespace feedscope
