#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>

namespace feedscope {

/// Calls `work(i)` for every i below `count`, on all processors, small numbers first. All are called unless
/// one throws Cancelled: then no more are started. At the end the exception of the smallest number is thrown.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work);
/// Runs several tasks likewise; the longest should be first.
void in_parallel(std::initializer_list<std::function<void()>> tasks);

/// Calls `make(i)` for every i below `count` on all processors, at most a few ahead, and the functions that
/// it returns one by one in order of i. The first exception is thrown once all started calls have ended; no
/// more are started.
void in_order(std::size_t count, const std::function<std::function<void()>(std::size_t)>& make);

}  // namespace feedscope
