// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QTest>

#include <memory>

#ifdef QT_GUI_LIB
#include <QGuiApplication>
#endif

namespace tp::test {

/// What a test class needs of its process before it begins: nothing, or an application object.
using Application = std::unique_ptr<QCoreApplication>;
inline Application nothing(int&, char**) { return {}; }
inline Application event_loop(int& argc, char** argv) {
    return std::make_unique<QCoreApplication>(argc, argv);
}
#ifdef QT_GUI_LIB
inline Application window(int& argc, char** argv) {
    auto application = std::make_unique<QGuiApplication>(argc, argv);
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi); // as QTEST_MAIN does
    return application;
}
#endif

/// Names a test class of a program that holds those of a folder. Lives as long as the program.
struct TestClass {
    using MakeApplication = Application (*)(int& argc, char** argv);
    using MakeTest = std::unique_ptr<QObject> (*)();
    TestClass(const char* name, MakeApplication application, MakeTest test);
};

} // namespace tp::test

/// At the end of `space`.cpp: its test class, which the program of the folder runs as `test_FOLDER space`. `need` is one of the
/// functions above.
#define TP_TEST(space, Class, need)                                                                          \
    static const tp::test::TestClass tp_test_class_of_##space(                                               \
        #space, tp::test::need,                                                                              \
        []() -> std::unique_ptr<QObject> { return std::make_unique<space::Class>(); });
