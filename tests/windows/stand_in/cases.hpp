// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "QtGlobal"
#include "text.hpp"

#include <algorithm>
#include <any>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

// What of Qt Test the tests of rooms without Qt use, where Qt Test is not: for Windows, as Debian builds nothing of Qt for it.

#define Q_OBJECT                                                                                             \
public:                                                                                                      \
    static void add_cases(std::vector<tp_stand_in::Case>& cases);                                            \
                                                                                                             \
private:
#define slots
#define Q_DECLARE_METATYPE(type)

class QObject {
public:
    virtual ~QObject() = default;
};

namespace tp_stand_in {

struct Case {
    std::string name;
    std::function<void(QObject&)> run;
};

struct Row {
    std::string name;
    std::vector<std::any> values;
};

struct State {
    std::vector<std::string> columns;
    std::vector<Row> rows;
    const Row* row = nullptr;
    std::string current;
    int passed = 0, failed = 0, skipped = 0;
    bool case_failed = false, case_skipped = false;
};

inline State& state() {
    static State state;
    return state;
}

/// The case, and the row of its table.
inline std::string running() { return state().current + (state().row ? "(" + state().row->name + ")" : ""); }

inline void fail(const std::string& what, const char* file, int line) {
    state().case_failed = true;
    std::printf("FAIL   %s\n       %s\n       %s:%d\n", running().c_str(), what.c_str(), file, line);
}

template <typename Value>
std::string shown(const Value& value) {
    if constexpr (requires(std::ostringstream & out) { out << value; }) {
        std::ostringstream out;
        out.precision(17);
        out << value;
        return out.str();
    } else {
        return "(a value)";
    }
}

/// As Qt compares: numbers with a fraction need be alike to 12 digits, 5 of a float.
template <typename One, typename Other>
bool alike(const One& one, const Other& other) {
    if constexpr (std::is_floating_point_v<One> && std::is_floating_point_v<Other>) {
        if (std::isnan(one) || std::isnan(other))
            return std::isnan(one) && std::isnan(other);
        if (std::isinf(one) || std::isinf(other))
            return one == other;
        constexpr double digits = std::is_same_v<One, float> ? 1e5 : 1e12;
        return std::abs(one - other) * digits <= std::min(std::abs(one), std::abs(other));
    } else if constexpr (std::is_convertible_v<One, const char*> &&
                         std::is_convertible_v<Other, const char*>) {
        return std::string_view(one) ==
               std::string_view(other); // as Qt Test: what is written there, not where
    } else {
        return one == other;
    }
}

template <typename One, typename Other>
bool compare(const One& one, const Other& other, const char* what, const char* file, int line) {
    if (alike(one, other))
        return true;
    fail(std::string(what) + ": " + shown(one) + ", expected " + shown(other), file, line);
    return false;
}

template <typename Value>
Value fetched(const char* column) {
    for (std::size_t i = 0; i < state().columns.size(); ++i)
        if (state().columns[i] == column)
            return std::any_cast<Value>(state().row->values.at(i));
    throw std::bad_any_cast();
}

/// What is written behind a row's name; texts become the type that a column of them has.
class RowWriter {
public:
    explicit RowWriter(std::size_t row) : row_(row) {}
    template <typename Value>
    RowWriter& operator<<(const Value& value) {
        if constexpr (std::is_convertible_v<Value, const char*>)
            state().rows[row_].values.emplace_back(QString(value));
        else
            state().rows[row_].values.emplace_back(value);
        return *this;
    }

private:
    std::size_t row_;
};

inline bool wait_until(const std::function<bool()>& done, int ms) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(ms);
    while (!done()) {
        if (std::chrono::steady_clock::now() > end)
            return done();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

inline void run_one(QObject& object, const std::map<std::string, Case>& all, const Case& one) {
    state().case_failed = state().case_skipped = false;
    const auto aside = [&](const char* name) {
        if (const auto found = all.find(name); found != all.end())
            found->second.run(object);
    };
    aside("init");
    if (!state().case_failed && !state().case_skipped)
        one.run(object);
    aside("cleanup");
    ++(state().case_failed ? state().failed : state().case_skipped ? state().skipped : state().passed);
}

/// Runs all cases, each with all its rows; how many failed.
inline int run_all(QObject& object, const std::vector<Case>& cases) {
    std::map<std::string, Case> all;
    for (const Case& one : cases)
        all.emplace(one.name, one);
    const auto aside = [&](const char* name) {
        if (const auto found = all.find(name); found != all.end())
            found->second.run(object);
    };
    aside("initTestCase");
    for (const Case& one : cases) {
        static const std::vector<std::string> no_case{"init", "cleanup", "initTestCase", "cleanupTestCase"};
        if (std::find(no_case.begin(), no_case.end(), one.name) != no_case.end() ||
            one.name.ends_with("_data"))
            continue;
        State& now = state();
        now.current = one.name;
        now.columns.clear();
        now.rows.clear();
        now.row = nullptr;
        if (const auto data = all.find(one.name + "_data"); data != all.end()) {
            data->second.run(object);
            for (const Row& row : now.rows) {
                now.row = &row;
                run_one(object, all, one);
            }
        } else {
            run_one(object, all, one);
        }
    }
    state().row = nullptr;
    aside("cleanupTestCase");
    std::printf("Totals: %d passed, %d failed, %d skipped\n", state().passed, state().failed,
                state().skipped);
    return state().failed;
}

/// Runs a test class; the process's exit status.
template <typename Test>
int run() {
    Test test;
    std::vector<Case> cases;
    Test::add_cases(cases);
    return run_all(test, cases) == 0 ? 0 : 1;
}

} // namespace tp_stand_in

namespace QTest {

template <typename Value>
void addColumn(const char* name) {
    tp_stand_in::state().columns.emplace_back(name);
}

inline tp_stand_in::RowWriter newRow(const char* name) {
    tp_stand_in::state().rows.push_back({name, {}});
    return tp_stand_in::RowWriter(tp_stand_in::state().rows.size() - 1);
}

template <typename... Values>
tp_stand_in::RowWriter addRow(const char* format, Values... values) {
    char name[200];
    std::snprintf(name, sizeof name, format, values...);
    return newRow(name);
}

inline const char* currentTestFunction() { return tp_stand_in::state().current.c_str(); }
inline const char* currentDataTag() {
    return tp_stand_in::state().row ? tp_stand_in::state().row->name.c_str() : nullptr;
}
inline bool currentTestFailed() { return tp_stand_in::state().case_failed; }
inline void qWait(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }
inline void qSleep(int ms) { qWait(ms); }

} // namespace QTest

#define QVERIFY2(condition, words)                                                                           \
    do {                                                                                                     \
        if (!static_cast<bool>(condition)) {                                                                 \
            tp_stand_in::fail(std::string(#condition ": ") + std::string(words), __FILE__, __LINE__);        \
            return;                                                                                          \
        }                                                                                                    \
    } while (false)
#define QVERIFY(condition)                                                                                   \
    do {                                                                                                     \
        if (!static_cast<bool>(condition)) {                                                                 \
            tp_stand_in::fail(#condition, __FILE__, __LINE__);                                               \
            return;                                                                                          \
        }                                                                                                    \
    } while (false)
#define QCOMPARE(one, other)                                                                                 \
    do {                                                                                                     \
        if (!tp_stand_in::compare(one, other, #one, __FILE__, __LINE__))                                     \
            return;                                                                                          \
    } while (false)
#define QFAIL(words)                                                                                         \
    do {                                                                                                     \
        tp_stand_in::fail(words, __FILE__, __LINE__);                                                        \
        return;                                                                                              \
    } while (false)
#define QSKIP(words)                                                                                         \
    do {                                                                                                     \
        std::printf("SKIP   %s: %s\n", tp_stand_in::running().c_str(), words);                               \
        tp_stand_in::state().case_skipped = true;                                                            \
        return;                                                                                              \
    } while (false)
#define QFETCH(type, name) const auto name = tp_stand_in::fetched<type>(#name)
#define QTRY_VERIFY_WITH_TIMEOUT(condition, ms)                                                              \
    do {                                                                                                     \
        tp_stand_in::wait_until([&] { return static_cast<bool>(condition); }, ms);                           \
        QVERIFY(condition);                                                                                  \
    } while (false)
#define QTRY_COMPARE_WITH_TIMEOUT(one, other, ms)                                                            \
    do {                                                                                                     \
        tp_stand_in::wait_until([&] { return tp_stand_in::alike(one, other); }, ms);                         \
        QCOMPARE(one, other);                                                                                \
    } while (false)

#define QTRY_COMPARE(one, other) QTRY_COMPARE_WITH_TIMEOUT(one, other, 5000)
#define QTRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, 5000)

#define QTEST_APPLESS_MAIN(type)                                                                             \
    int main() { return tp_stand_in::run<type>(); }
#define QTEST_GUILESS_MAIN(type) QTEST_APPLESS_MAIN(type)
