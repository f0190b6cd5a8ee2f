// SPDX-License-Identifier: Apache-2.0
#include "core/processes/message.hpp"

#include <QTest>

#include <array>
#include <cstdint>
#include <limits>

using namespace tp;

class MessageTest : public QObject {
    Q_OBJECT

private slots:
    void what_is_put_in_comes_out() {
        const std::array<std::int32_t, 3> numbers{1, -2, std::numeric_limits<std::int32_t>::min()};
        Message message = MessageWriter().add(std::int64_t{-5}).add("größer").add(numbers).add("").take();
        MessageReader reader(message);
        QCOMPARE(reader.number(), std::int64_t{-5});
        QCOMPARE(reader.text(), std::string("größer"));
        std::array<std::int32_t, 8> room{};
        QCOMPARE(reader.numbers(room), std::size_t{3});
        QVERIFY(std::equal(numbers.begin(), numbers.end(), room.begin()));
        QVERIFY(!reader.whole());
        QCOMPARE(reader.text(), std::string());
        QVERIFY(reader.whole());
    }

    void what_is_cut_anywhere_is_not_whole() {
        const std::array<std::int32_t, 2> numbers{4, 5};
        const Message message = MessageWriter().add(std::int64_t{3}).add("words").add(numbers).take();
        for (std::size_t kept = 0; kept < message.bytes.size(); ++kept) {
            Message cut;
            cut.bytes.assign(message.bytes.begin(),
                             message.bytes.begin() + static_cast<std::ptrdiff_t>(kept));
            MessageReader reader(cut);
            std::array<std::int32_t, 2> room{};
            reader.number();
            reader.text();
            reader.numbers(room);
            QVERIFY2(!reader.whole(), qPrintable(QString::number(kept)));
        }
    }

    void lengths_that_lie_are_not_believed() {
        for (const std::int64_t length :
             {std::int64_t{-1}, std::int64_t{9}, std::numeric_limits<std::int64_t>::max(),
              std::numeric_limits<std::int64_t>::min()}) {
            Message text = MessageWriter().add(length).add(std::int64_t{0}).take();
            MessageReader reader(text);
            QCOMPARE(reader.text(), std::string());
            QVERIFY(!reader.whole());

            std::array<std::int32_t, 4> room{};
            Message numbers = MessageWriter().add(length).add(std::int64_t{0}).take();
            MessageReader numbers_reader(numbers);
            QCOMPARE(numbers_reader.numbers(room), std::size_t{0});
            QVERIFY(!numbers_reader.whole());
        }
    }

    void more_numbers_than_there_is_room_for_are_refused() {
        const std::array<std::int32_t, 3> numbers{1, 2, 3};
        Message message = MessageWriter().add(numbers).take();
        std::array<std::int32_t, 2> room{};
        MessageReader reader(message);
        QCOMPARE(reader.numbers(room), std::size_t{0});
        QVERIFY(!reader.whole());
    }

    void a_descriptor_that_is_missing_is_none() {
        Message message = MessageWriter().add(std::int64_t{1}).take();
        MessageReader reader(message);
        reader.number();
        QVERIFY(reader.whole());
        QVERIFY(!reader.descriptor().ok());
        QVERIFY(!reader.whole());
    }
};

QTEST_GUILESS_MAIN(MessageTest)
#include "message_test.moc"
