// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/path_text.hpp"
#include "test_program.hpp"

#include <QTest>

#include <random>

namespace path_text_test {

using namespace tp;
namespace fs = std::filesystem;

class PathTextTest : public QObject {
    Q_OBJECT

private slots:
    void any_bytes_come_back() {
        std::mt19937 random(1);
        for (int i = 0; i < 20'000; ++i) {
            std::string bytes(random() % 40, ' ');
            for (char& byte : bytes)
                byte = static_cast<char>(random() % (i % 2 == 0 ? 256 : 128));
            const auto back = path_of(path_text(bytes));
            QVERIFY(back.ok());
            QCOMPARE(back->string(), bytes);
        }
    }

    void what_it_does_not_write_is_refused() {
        for (const char* text : {"100%", "%:plain", "%:a%2", "%:%zz"})
            QVERIFY2(!path_of(QString::fromUtf8(text)).ok(), text);
        QCOMPARE(path_text("Jörg/IMG 1.jpg"), QStringLiteral("Jörg/IMG 1.jpg"));
    }

    void what_leads_out_is_known() {
        for (const char* out : {"", "/etc/passwd", "..", "a/../b", "a/..", "./a", "a//", "a/./b"})
            QVERIFY2(!stays_below(out), out);
        QVERIFY(!stays_below(fs::path(std::string("a\0b", 3))));
        for (const char* in : {"a", "a/b.jpg", "..a", "a../b", "..."})
            QVERIFY2(stays_below(in), in);
    }
};

} // namespace path_text_test

TP_TEST(path_text_test, PathTextTest, event_loop)
#include "path_text_test.moc"
