// SPDX-License-Identifier: Apache-2.0
// Counts what a thread takes from the heap. It replaces operators of the whole program: for one source of it alone.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace tp::testing {

alignas(64) thread_local bool counting = false; ///< of this thread; why aligned: cmake/Compiler.cmake, mold
std::atomic<long> allocations{0};               ///< of all threads that count

inline void* counted_or_null(std::size_t size) noexcept {
    if (counting)
        allocations.fetch_add(1);
    return std::malloc(size == 0 ? 1 : size);
}

inline void* counted(std::size_t size) {
    if (void* memory = counted_or_null(size))
        return memory;
    throw std::bad_alloc();
}

} // namespace tp::testing

void* operator new(std::size_t size) { return tp::testing::counted(size); }
void* operator new[](std::size_t size) { return tp::testing::counted(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return tp::testing::counted_or_null(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return tp::testing::counted_or_null(size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
