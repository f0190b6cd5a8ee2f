// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "cases.hpp"

#include <cstdio>
#include <map>
#include <string>

// What tests/support/test_program is to the tests of a folder that are one program.

namespace tp_stand_in {

/// Of each test, by its file's name, what runs it.
inline std::map<std::string, int (*)()>& tests() {
    static std::map<std::string, int (*)()> tests;
    return tests;
}

struct TestClass {
    TestClass(const char* name, int (*run)()) { tests().emplace(name, run); }
};

} // namespace tp_stand_in

#define TP_TEST(space, Class, need)                                                                          \
    static const tp_stand_in::TestClass tp_test_class_of_##space(#space, tp_stand_in::run<space::Class>);
