#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <cstdint>

namespace feedscope::ui {

/// A value as the nearest whole number of steps of `quantum`.
std::int64_t steps(double value, double quantum);

/// Whole numbers of one kind in the order of a path, small ones in few bytes: zigzag, then seven bits a byte,
/// the lowest first.
class PageColumn {
 public:
  void add(std::int64_t number);
  const QByteArray& bytes() const { return bytes_; }

 private:
  QByteArray bytes_;
};

/// The data of a page: a description as JSON and the columns that it names, compressed together.
class PageData {
 public:
  /// Appends a column. Returns what the description says of it: its first byte and their number.
  QJsonObject add(const PageColumn& column);
  /// Four bytes with the length of the description, the lowest first; the description; the columns. As a zlib
  /// stream.
  QByteArray packed(const QJsonObject& description) const;

 private:
  QByteArray columns_;
};

/// `bytes` as a zlib stream, which browsers call "deflate".
QByteArray deflated(const QByteArray& bytes);

}  // namespace feedscope::ui
