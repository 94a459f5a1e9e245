#include "tests/benchmark/heap_meter.h"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> in_use{0};
std::atomic<std::size_t> peak_use{0};

void* counted(void* block) {
  if (block == nullptr) {
    throw std::bad_alloc();
  }
  const std::size_t now = in_use += malloc_usable_size(block);
  for (std::size_t peak = peak_use; now > peak && !peak_use.compare_exchange_weak(peak, now);) {
  }
  return block;
}

void release(void* block) {
  in_use -= malloc_usable_size(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(std::malloc(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto align = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(align, (size + align - 1) / align * align));
}
void operator delete(void* block) noexcept {
  release(block);
}
void operator delete(void* block, std::size_t) noexcept {
  release(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
  release(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  release(block);
}

namespace feedscope::benchmark {

HeapMeter::HeapMeter() : start_(in_use) {
  peak_use = start_;
}

std::size_t HeapMeter::peak() const {
  return peak_use - start_;
}

std::size_t HeapMeter::held() const {
  const std::size_t now = in_use;
  return now - std::min(now, start_);
}

}  // namespace feedscope::benchmark
