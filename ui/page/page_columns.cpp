#include "ui/page/page_columns.h"

#include <QJsonDocument>
#include <cmath>

namespace feedscope::ui {

std::int64_t steps(double value, double quantum) {
  return static_cast<std::int64_t>(std::floor(value / quantum + 0.5));
}

void PageColumn::add(std::int64_t number) {
  auto rest = (static_cast<std::uint64_t>(number) << 1U) ^ static_cast<std::uint64_t>(number >> 63);
  constexpr unsigned low = 0x7f;
  while (rest > low) {
    bytes_.append(static_cast<char>((rest & low) | 0x80U));
    rest >>= 7U;
  }
  bytes_.append(static_cast<char>(rest));
}

QJsonObject PageData::add(const PageColumn& column) {
  const QJsonObject place{{"from", columns_.size()}, {"bytes", column.bytes().size()}};
  columns_.append(column.bytes());
  return place;
}

QByteArray PageData::packed(const QJsonObject& description) const {
  const QByteArray json = QJsonDocument(description).toJson(QJsonDocument::Compact);
  QByteArray whole;
  for (int byte = 0; byte < 4; ++byte) {
    whole.append(static_cast<char>((json.size() >> (8 * byte)) & 0xff));
  }
  return deflated(whole + json + columns_);
}

QByteArray deflated(const QByteArray& bytes) {
  constexpr int best = 9;
  constexpr qsizetype length_of_qt = 4;
  return qCompress(bytes, best).mid(length_of_qt);
}

}  // namespace feedscope::ui
