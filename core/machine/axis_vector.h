#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <initializer_list>
#include <optional>

namespace feedscope {

/// Unit of an axis: mm and mm/s, or rad and rad/s.
enum class AxisKind : std::uint8_t { linear, rotary };

/// An axis of a machine, with its letter in programs, files and on screen.
struct AxisInfo {
  char name = ' ';
  AxisKind kind = AxisKind::linear;
  bool operator==(const AxisInfo&) const = default;
};

/// Axes of a machine in their order; at most `capacity`.
class AxisList {
 public:
  static constexpr std::size_t capacity = 6;

  constexpr AxisList() = default;
  constexpr AxisList(std::initializer_list<AxisInfo> axes) {
    assert(axes.size() <= capacity);
    for (const AxisInfo& axis : axes) {
      axes_[size_++] = axis;
    }
  }

  constexpr std::size_t size() const { return size_; }
  constexpr const AxisInfo& operator[](std::size_t i) const { return axes_[i]; }
  constexpr const AxisInfo* begin() const { return axes_.data(); }
  constexpr const AxisInfo* end() const { return axes_.data() + size_; }
  /// Index of the axis with this name; none if there is none.
  constexpr std::optional<std::size_t> find(char name) const {
    for (std::size_t i = 0; i < size_; ++i) {
      if (axes_[i].name == name) {
        return i;
      }
    }
    return std::nullopt;
  }
  bool operator==(const AxisList&) const = default;

 private:
  std::array<AxisInfo, capacity> axes_{};
  std::size_t size_ = 0;
};

/// Linear axes that machines can have: they move the coordinates X, Y and Z.
inline constexpr AxisList known_axes{{'X'}, {'Y'}, {'Z'}};
/// Axes that can limit a motion. The axis of a limiting cause is an index of this list, which begins with
/// known_axes.
inline constexpr AxisList cause_axes{
    {'X'}, {'Y'}, {'Z'}, {'A', AxisKind::rotary}, {'B', AxisKind::rotary}, {'C', AxisKind::rotary}};

/// One value for each axis of a machine, together with the names that tables, files and charts need.
template <class T>
class AxisVector {
 public:
  AxisVector() : AxisVector(known_axes) {}
  explicit AxisVector(const AxisList& axes) : axes_(axes) {}

  const AxisList& axes() const { return axes_; }
  std::size_t size() const { return axes_.size(); }
  char name(std::size_t i) const { return axes_[i].name; }
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  /// Value of the axis with this name; null if there is none.
  const T* find(char name) const {
    const auto place = axes_.find(name);
    return place ? &values_[*place] : nullptr;
  }
  T* begin() { return values_.data(); }
  T* end() { return values_.data() + size(); }
  const T* begin() const { return values_.data(); }
  const T* end() const { return values_.data() + size(); }
  bool operator==(const AxisVector&) const = default;

 private:
  AxisList axes_;
  std::array<T, AxisList::capacity> values_{};
};

}  // namespace feedscope
