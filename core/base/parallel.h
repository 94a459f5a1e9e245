#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>

namespace feedscope {

/// Calls `work(i)` for every i below `count`, on as many threads as there are processors, those with small
/// numbers first. All are called, unless one throws Cancelled: then no more are begun. At the end the
/// exception of the smallest number is thrown.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work);
/// The same of some tasks; what takes longest stands first.
void in_parallel(std::initializer_list<std::function<void()>> tasks);

/// Calls `make(i)` for every i below `count` on as many threads as there are processors, a few ahead at most,
/// and what that returns in order of i, one after the other. What the first one throws is thrown when all
/// that is under way has ended; others are not begun any more.
void in_order(std::size_t count, const std::function<std::function<void()>(std::size_t)>& make);

}  // namespace feedscope
