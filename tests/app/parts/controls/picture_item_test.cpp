// SPDX-License-Identifier: Apache-2.0
// Where a picture is drawn: whole, over everything, stretched, or at a place.
#include "app/parts/controls/picture_item.hpp"
#include "drawn_item.hpp"

#include <QTest>

using namespace tp;
using namespace tp::testing;

namespace {

const QColor left_half(220, 30, 30), right_half(30, 30, 220);

/// 40 × 20 px, in two halves.
QImage drawn() {
    QImage picture(40, 20, QImage::Format_RGB32);
    for (int x = 0; x < 40; ++x)
        for (int y = 0; y < 20; ++y)
            picture.setPixelColor(x, y, x < 20 ? left_half : right_half);
    return picture;
}

struct Bench : DrawnItem<PictureItem> {
    explicit Bench(QSize size = {80, 80}) : DrawnItem(size) { set("picture", drawn()); }
    QRect left() { return extent_of(picture(), left_half); }
    QRect right() { return extent_of(picture(), right_half); }
};

/// Up to the pixel at which the halves meet, which is smooth.
bool near(const QRect& one, const QRect& other) {
    const QRect apart(one.x() - other.x(), one.y() - other.y(), one.width() - other.width(),
                      one.height() - other.height());
    return std::abs(apart.x()) + std::abs(apart.y()) < 3 && std::abs(apart.width()) < 3 &&
           std::abs(apart.height()) < 3;
}

} // namespace

class PictureItemTest : public QObject {
    Q_OBJECT
private slots:
    void all_of_it_in_the_middle_as_large_as_there_is_room() {
        Bench bench;
        QVERIFY(near(bench.left(), {0, 20, 40, 40}) && near(bench.right(), {40, 20, 40, 40}));
        Bench wide({120, 40});
        QVERIFY(near(wide.left(), {20, 0, 40, 40}) && near(wide.right(), {60, 0, 40, 40}));
    }

    void its_middle_over_everything() {
        Bench bench({60, 80});
        const QColor mark(30, 220, 30);
        QImage marked = drawn();
        for (int y = 0; y < 20; ++y)
            marked.setPixelColor(0, y, mark);
        bench.set("picture", marked);
        bench.set("fill", PictureItem::Stretch);
        QVERIFY(!extent_of(bench.picture(), mark).isEmpty());
        bench.set("fill", PictureItem::Cover); // 160 × 80, of which 60 are seen
        QVERIFY(near(bench.left(), {0, 0, 30, 80}) && near(bench.right(), {30, 0, 30, 80}));
        QVERIFY(extent_of(bench.picture(), mark).isEmpty());
    }

    void all_of_it_over_everything() {
        Bench bench;
        bench.set("fill", PictureItem::Stretch);
        QVERIFY(near(bench.left(), {0, 0, 40, 80}) && near(bench.right(), {40, 0, 40, 80}));
    }

    void at_its_place_whatever_the_shape() {
        Bench bench;
        bench.set("place", QRectF(-40, 10, 100, 20));
        QVERIFY(near(bench.left(), {0, 10, 10, 20}) && near(bench.right(), {10, 10, 50, 20}));
        bench.set("place", QRectF());
        QVERIFY(near(bench.left(), {0, 20, 40, 40}));
    }

    void no_picture_is_no_fault() {
        Bench bench;
        bench.set("picture", QImage());
        QVERIFY(bench.left().isEmpty() && bench.right().isEmpty());
        bench.set("picture", drawn());
        QVERIFY(!bench.left().isEmpty());
        bench.set("picture", QVariant());
        QVERIFY(bench.left().isEmpty());
    }
};

QTEST_MAIN(PictureItemTest)
#include "picture_item_test.moc"
