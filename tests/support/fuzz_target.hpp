// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

/// The entry of a libFuzzer target that puts any bytes through `complaint`, a function from text to what does
/// not hold for it, and dies of the first complaint.
#define TP_FUZZ_TARGET(complaint)                                                                            \
    extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {                      \
        const std::string words = complaint(std::string_view(reinterpret_cast<const char*>(data), size));    \
        if (!words.empty()) {                                                                                \
            std::fprintf(stderr, "%s\n", words.c_str());                                                     \
            std::abort();                                                                                    \
        }                                                                                                    \
        return 0;                                                                                            \
    }
