// SPDX-License-Identifier: Apache-2.0
// What core/processes needs of Windows: that a helper inherits nothing else, that what it hands over is looked at only where it can
// be, and what it can no longer do.
#include "../core/processes/asked.hpp"
#include "../core/processes/own_processes.hpp"
#include "core/base/windows/overlapped_io.hpp"
#include "core/base/windows/pipe_pair.hpp"
#include "core/processes/channel.hpp"
#include "core/processes/child_process.hpp"
#include "core/processes/shared_memory.hpp"

#include <QScopeGuard>
#include <QTest>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>
#include <windows.h>

using namespace tp;
using namespace tp::test;
using windows::Handle;

namespace {

Descriptor descriptor_of(HANDLE handle) {
    return handle == nullptr ? Descriptor() : Descriptor(reinterpret_cast<DescriptorNumber>(handle));
}

/// Of 64 KB, of a file or, where there is none, of the system's.
Descriptor memory(DWORD how, HANDLE file = INVALID_HANDLE_VALUE) {
    return descriptor_of(CreateFileMappingW(file, nullptr, how, 0, 65536, nullptr));
}

} // namespace

class WindowsProcessesTest : public QObject {
    Q_OBJECT

private slots:
    void nothing_that_may_be_inherited_reaches_it() {
        auto ends = windows::pipe_pair(PIPE_TYPE_BYTE, 100);
        QVERIFY(ends.has_value());
        QVERIFY(SetHandleInformation(ends->second.get(), HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT) != 0);
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        ends->second.reset();
        DWORD there = 0; // a pipe whose other end somebody has is silent, and no error
        QVERIFY(PeekNamedPipe(ends->first.get(), nullptr, 0, nullptr, &there, nullptr) == 0);
        QCOMPARE(text_in((*helper)->ask(order("say", "well"))), std::string("well"));
    }

    void what_lies_on_its_channel_is_gone_data() {
        QTest::addColumn<QString>("lie");
        for (const char* lie : {"hand over this process itself", "hand over what it has not",
                                "hand over more than a number", "say half a number", "say too much"})
            QTest::newRow(lie) << lie;
    }
    void what_lies_on_its_channel_is_gone() {
        QFETCH(QString, lie);
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        QCOMPARE(reason_in((*helper)->ask(order("try", lie))), QString("gone"));
        QCOMPARE(own_processes(), 0);
    }

    /// Which the system lets go of with the program that holds it.
    void it_ends_where_nobody_holds_its_leash() {
        auto ends = Channel::pair();
        QVERIFY(ends.has_value());
        const std::vector<DescriptorNumber> given{ends->second.descriptor()};
        auto process = ChildProcess::start(double_program, {}, given, Streams::none);
        QVERIFY(process.has_value());
        const auto killed = qScopeGuard([&] { process->kill(); });
        QVERIFY(ends->first.other_end_is(*process));
        auto ready = ends->first.receive(std::chrono::seconds(20));
        auto* const message = std::get_if<Message>(&ready);
        QVERIFY(message != nullptr);
        QCOMPARE(message->descriptors.size(), std::size_t{1});
        QVERIFY(ends->first.send(order("compute for ever")));
        const auto handle = reinterpret_cast<HANDLE>(process->number());
        QCOMPARE(WaitForSingleObject(handle, 0), DWORD{WAIT_TIMEOUT});
        message->descriptors.clear();
        QCOMPARE(WaitForSingleObject(handle, 20'000), DWORD{WAIT_OBJECT_0});
    }

    void memory_all_of_which_is_there_is_read_and_not_written() {
        const Descriptor whole = memory(PAGE_READWRITE | SEC_COMMIT);
        QVERIFY(whole.ok());
        const auto view = received(whole);
        QVERIFY(view.has_value());
        QCOMPARE(view->size(), std::size_t{65536});
        MEMORY_BASIC_INFORMATION pages{};
        QVERIFY(VirtualQuery(view->data(), &pages, sizeof pages) != 0);
        QCOMPARE(pages.Protect, DWORD{PAGE_READONLY});
    }

    void memory_that_can_still_change_is_not_looked_at() {
        QVERIFY(!received(memory(PAGE_READWRITE | SEC_RESERVE)).has_value());
        const std::string path =
            (std::filesystem::temp_directory_path() / "touchphoto memory of a file").string();
        std::ofstream(path) << std::string(65536, 'x');
        const Handle file(CreateFileA(path.c_str(), GENERIC_READ | GENERIC_WRITE, 0, nullptr, OPEN_EXISTING,
                                      FILE_FLAG_DELETE_ON_CLOSE, nullptr));
        QVERIFY(file);
        const Descriptor of_file = memory(PAGE_READWRITE, file.get());
        QVERIFY(of_file.ok());
        QVERIFY(!received(of_file).has_value());
    }

    void what_is_no_memory_is_not_looked_at() {
        QVERIFY(!received(Descriptor()).has_value());
        QVERIFY(!received(descriptor_of(CreateEventW(nullptr, TRUE, FALSE, nullptr))).has_value());
        QVERIFY(!received(descriptor_of(OpenProcess(PROCESS_ALL_ACCESS, FALSE, GetCurrentProcessId())))
                     .has_value());
        QVERIFY(
            !received(descriptor_of(CreateFileW(L"NUL", GENERIC_READ, 0, nullptr, OPEN_EXISTING, 0, nullptr)))
                 .has_value());
    }

    void confined_it_cannot_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("not_in_wine");
        const char* const integrity = "Wine takes the integrity of a process and heeds it nowhere";
        const char* const policies = "Wine says yes to a policy of a process and keeps none";
        QTest::newRow("have a privilege") << "have a privilege"
                                          << "";
        QTest::newRow("write a file") << "write a file" << integrity;
        QTest::newRow("end another") << "end another" << integrity;
        QTest::newRow("look into another") << "look into another" << integrity;
        QTest::newRow("start a program") << "start a program" << policies;
        QTest::newRow("map code") << "map code" << policies;
        QTest::newRow("make data code") << "make data code" << policies;
        QTest::newRow("take much memory") << "take much memory"
                                          << "Wine's jobs have no limit on memory";
    }
    void confined_it_cannot() {
        QFETCH(QString, what);
        QFETCH(QString, not_in_wine);
        if (in_wine && !not_in_wine.isEmpty())
            QSKIP(qPrintable(not_in_wine));
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY2(helper.ok(), helper.error().c_str());
        const std::int64_t problem = number_in((*helper)->ask(order("try", what)));
        QVERIFY2(problem > 0, std::to_string(problem));
        QCOMPARE(text_in((*helper)->ask(order("say", "still here"))), std::string("still here"));
    }
};

QTEST_GUILESS_MAIN(WindowsProcessesTest)
#include "processes_test.moc"
