// SPDX-License-Identifier: Apache-2.0
// The main function of a program of tests: test_FOLDER FILE_test [words of Qt Test…].
#include "test_program.hpp"

#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace tp::test {

namespace {

struct Known {
    TestClass::MakeApplication application;
    TestClass::MakeTest test;
};

/// By name. Filled before `main` begins.
std::map<std::string, Known>& known() {
    static std::map<std::string, Known> classes;
    return classes;
}

int usage() {
    std::fputs("Name the test to run, then what Qt Test is to do (-help tells). There are:\n", stderr);
    for (const auto& [name, of] : known())
        std::fprintf(stderr, "  %s\n", name.c_str());
    return 2;
}

int run(int argc, char** argv) {
    const auto chosen = argc < 2 ? known().end() : known().find(argv[1]);
    if (chosen == known().end())
        return usage();
    std::vector<char*> words(argv, argv + argc);
    words.erase(words.begin() + 1);
    auto count = static_cast<int>(words.size());
    words.push_back(nullptr);
    const auto application = chosen->second.application(count, words.data());
    const auto test = chosen->second.test();
    return QTest::qExec(test.get(), count, words.data());
}

} // namespace

TestClass::TestClass(const char* name, MakeApplication application, MakeTest test) {
    known().emplace(name, Known{application, test});
}

} // namespace tp::test

int main(int argc, char** argv) { return tp::test::run(argc, argv); }
