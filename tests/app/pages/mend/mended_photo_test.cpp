// SPDX-License-Identifier: Apache-2.0
#include "mend_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <utility>

namespace mended_photo_test {

using namespace tp;
using State = MendedPhoto::State;

class MendedPhotoTest : public QObject {
    Q_OBJECT
private slots:
    void the_table_of_its_states_holds() {
        const QTemporaryDir folder;
        const auto lead_to = [&](MendedPhoto& photo, State state) {
            if (state == State::Looking)
                photo.look();
            else if (state != State::Empty)
                show(photo, folder.path(), state == State::Ready);
            QCOMPARE(photo.state(), state);
        };
        for (const State from : {State::Empty, State::Looking, State::Ready, State::Problem}) {
            MendedPhoto looks, usable, useless, away;
            for (MendedPhoto* photo : {&looks, &usable, &useless, &away})
                lead_to(*photo, from);
            looks.look();
            QCOMPARE(looks.state(), State::Looking);
            show(usable, folder.path(), true);
            QCOMPARE(usable.state(), State::Ready);
            show(useless, folder.path(), false);
            QCOMPARE(useless.state(), State::Problem);
            away.look_away();
            QCOMPARE(away.state(), from == State::Looking ? State::Empty : from);
        }
    }
    void who_looks_away_has_what_was_there() {
        const QTemporaryDir folder;
        MendedPhoto photo;
        show(photo, folder.path(), true);
        photo.look();
        QVERIFY(photo.usable() && !photo.ready());
        photo.look_away();
        QVERIFY(photo.ready());
        QCOMPARE(photo.name(), QString("drawn.png"));
    }
    void another_photograph_is_told_before_its_contours() {
        const QTemporaryDir folder;
        MendedPhoto photo;
        QStringList told;
        connect(&photo, &MendedPhoto::replaced, [&] { told << "replaced"; });
        connect(&photo, &MendedPhoto::changed, [&] { told << "changed"; });
        show(photo, folder.path(), true);
        photo.change([](MendWork& work) { work.faces.clear(); });
        QCOMPARE(told, QStringList({"replaced", "changed", "changed"}));
        QVERIFY(photo.work().faces.empty());
    }

private:
    static void show(MendedPhoto& photo, const QString& folder, bool usable) {
        MendPhoto drawn = drawn_mend_photo(folder);
        drawn.usable = usable;
        photo.show(std::move(drawn));
    }
};

} // namespace mended_photo_test

TP_TEST(mended_photo_test, MendedPhotoTest, event_loop)
#include "mended_photo_test.moc"
