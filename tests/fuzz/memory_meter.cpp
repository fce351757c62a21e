// SPDX-License-Identifier: MIT
#include "memory_meter.hpp"

#include <sanitizer/allocator_interface.h>

#include <algorithm>
#include <cstdint>

namespace planish::fuzz {
namespace {

bool measuring = false;
std::int64_t held = 0;
std::int64_t most = 0;

void on_allocation(const volatile void*, std::size_t size) {
  if (!measuring) return;
  held += static_cast<std::int64_t>(size);
  most = std::max(most, held);
}

void on_release(const volatile void* pointer) {
  if (!measuring || pointer == nullptr) return;
  held -=
      static_cast<std::int64_t>(__sanitizer_get_allocated_size(const_cast<const void*>(pointer)));
}

}  // namespace

MemoryMeter::MemoryMeter() {
  static const int installed = __sanitizer_install_malloc_and_free_hooks(on_allocation, on_release);
  static_cast<void>(installed);
  held = most = 0;
  measuring = true;
}

MemoryMeter::~MemoryMeter() { measuring = false; }

std::size_t MemoryMeter::peak() const { return static_cast<std::size_t>(most); }

}  // namespace planish::fuzz
