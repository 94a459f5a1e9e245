#pragma once

#include <gtest/gtest.h>

#include <QAbstractTextDocumentLayout>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextTable>
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "ui/paper/page_flow.h"

namespace feedscope::test {

/// Looks at a laid out text as a reader of its pages: on which page is each line.
class PageChecks {
 public:
  PageChecks(const QTextDocument& document, std::vector<ui::PagePart> pages, double height)
      : document_(document), pages_(std::move(pages)), height_(height) {}

  void check() const {
    check_lines();
    check_headings();
    for (QTextFrame* frame : document_.rootFrame()->childFrames()) {
      check_frame(*frame);
    }
    check_fill();
  }

 private:
  struct Line {
    double top, bottom;
  };

  std::vector<Line> lines_of(const QTextBlock& block) const {
    const double top = document_.documentLayout()->blockBoundingRect(block).top();
    std::vector<Line> lines;
    for (int i = 0; i < block.layout()->lineCount(); ++i) {
      const QRectF line = block.layout()->lineAt(i).rect();
      lines.push_back({top + line.top(), top + line.bottom()});
    }
    return lines;
  }

  /// Page that shows all of it; -1: none.
  int page_of(const Line& line) const {
    constexpr double rounding = 0.6;
    for (std::size_t i = 0; i < pages_.size(); ++i) {
      if (line.top > pages_[i].top - rounding && line.bottom < pages_[i].clip_bottom + rounding) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }
  int first_page(const QTextBlock& block) const { return page_of(lines_of(block).front()); }

  void check_lines() const {
    for (QTextBlock block = document_.begin(); block.isValid(); block = block.next()) {
      for (const Line& line : lines_of(block)) {
        if (!block.text().isEmpty() && line.bottom - line.top < height_) {
          EXPECT_NE(page_of(line), -1) << "cut or lost: " << block.text().toStdString();
        }
      }
    }
  }

  void check_headings() const {
    for (QTextBlock block = document_.begin(); block.isValid(); block = block.next()) {
      QTextBlock next = block.next();
      while (next.isValid() && next.text().isEmpty()) {
        next = next.next();
      }
      if (block.blockFormat().headingLevel() > 0 && next.isValid()) {
        EXPECT_EQ(first_page(block), first_page(next)) << "alone: " << block.text().toStdString();
      }
    }
  }

  std::set<int> pages_of(QTextFrame& frame) const {
    std::set<int> pages;
    const QTextBlock last = frame.lastCursorPosition().block();
    for (QTextBlock block = frame.firstCursorPosition().block();; block = block.next()) {
      for (const Line& line : lines_of(block)) {
        if (!block.text().isEmpty()) {
          pages.insert(page_of(line));
        }
      }
      if (block == last) {
        return pages;
      }
    }
  }

  /// Tables that a page holds, together with the heading and the sentence above them, are on one.
  void check_frame(QTextFrame& frame) const {
    constexpr double above = 60;
    const double size = document_.documentLayout()->frameBoundingRect(&frame).height();
    const bool figures =
        frame.firstCursorPosition().block().text().contains(QChar::ObjectReplacementCharacter);
    if (size < height_ - above && !figures) {
      EXPECT_EQ(pages_of(frame).size(), 1U)
          << "split: " << frame.firstCursorPosition().block().text().toStdString();
    }
    for (QTextFrame* child : frame.childFrames()) {
      check_frame(*child);
    }
  }

  void check_fill() const {
    constexpr double quarter = 0.25;
    for (std::size_t i = 0; i < pages_.size(); ++i) {
      EXPECT_LE(pages_[i].used(), height_ + 0.01) << "page " << i + 1;
      EXPECT_GT(pages_[i].used(), 0) << "page " << i + 1;
      if (i + 1 < pages_.size()) {
        EXPECT_GT(pages_[i].used(), quarter * height_) << "page " << i + 1 << " of " << pages_.size();
      }
    }
  }

  const QTextDocument& document_;
  std::vector<ui::PagePart> pages_;
  double height_;
};

inline void check_pages(const QTextDocument& document, const std::vector<ui::PagePart>& pages,
                        double height) {
  PageChecks(document, pages, height).check();
}

}  // namespace feedscope::test
