// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtGlobal>

#include <cstdint>
#include <random>

namespace tp::testing {

/// One thing that goes wrong for a while.
struct Trouble {
    int kind = 0;
    int from = 0; ///< tick
    int until = 0;
    double size = 0.0; ///< 0–1
};

inline Trouble any_trouble(std::mt19937& random, int kind, int ticks) {
    Trouble trouble;
    trouble.kind = kind;
    trouble.from = static_cast<int>(random() % static_cast<unsigned>(ticks));
    trouble.until = trouble.from + 1 + static_cast<int>(random() % 200);
    trouble.size = std::uniform_real_distribution<double>(0.0, 1.0)(random);
    return trouble;
}

/// How many random fault schedules a device's test tries: TP_SCHEDULES, or 2 000; a tenth of it under a
/// sanitizer, where each is ten times as slow.
inline int schedules() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    constexpr int usual = 200;
#elif defined(__clang__)
    constexpr int usual = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) ? 200 : 2000;
#else
    constexpr int usual = 2000;
#endif
    return qEnvironmentVariableIsSet("TP_SCHEDULES") ? qEnvironmentVariableIntValue("TP_SCHEDULES") : usual;
}

/// The number of the first one: TP_FIRST_SCHEDULE, or 0. Each number is another schedule, always the same.
inline int first_schedule() { return qEnvironmentVariableIntValue("TP_FIRST_SCHEDULE"); }

} // namespace tp::testing
