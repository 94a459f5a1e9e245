#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <cstdint>

namespace feedscope::ui {

/// A value as the nearest whole number of steps of `quantum`.
std::int64_t steps(double value, double quantum);

/// Whole numbers of one kind in the order of a path, small ones in few bytes: zigzag, then seven bits in each
/// byte, the lowest first.
class PageColumn {
 public:
  void add(std::int64_t number);
  const QByteArray& bytes() const { return bytes_; }

 private:
  QByteArray bytes_;
};

/// The data of a page: a JSON description and the columns that it refers to, compressed together.
class PageData {
 public:
  /// Appends a column. Returns its entry for the description: first byte and number of values.
  QJsonObject add(const PageColumn& column);
  /// A zlib stream of four bytes with the length of the description, the lowest first; the description; the
  /// columns.
  QByteArray packed(const QJsonObject& description) const;

 private:
  QByteArray columns_;
};

/// `bytes` as a zlib stream, which browsers call "deflate".
QByteArray deflated(const QByteArray& bytes);

}  // namespace feedscope::ui
