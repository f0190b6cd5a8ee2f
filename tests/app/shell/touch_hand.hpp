// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "page_window.hpp"

#include <QList>
#include <QPoint>
#include <QPointF>
#include <QPointingDevice>
#include <QQuickItem>
#include <QQuickWindow>
#include <QRectF>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <utility>

/// Fingers on a window, and nothing else: no key, no mouse, no client's action.
class TouchHand {
public:
    explicit TouchHand(QQuickWindow& window) : window_(window) {}

    /// Taps what has this name, scrolling to it as a hand does; a name that ends with "…" may go on, one that begins with
    /// it may begin otherwise. False where nothing of that name can be reached.
    bool tap(const QString& name) {
        QQuickItem* target = resting(name);
        if (target == nullptr || !bring_into_view(*target) || (target = resting(name)) == nullptr)
            return false;
        tap_at(middle_of(*target));
        return true;
    }
    /// Where it is when it has been laid out.
    bool rests(const QQuickItem& target) {
        QPoint before(-1, -1);
        return QTest::qWaitFor([&] {
            frame();
            return std::exchange(before, middle_of(target)) == middle_of(target);
        });
    }
    /// So many fingers, side by side.
    void tap_at(QPoint place, int fingers = 1) {
        press(place, fingers);
        release(place, fingers);
    }
    /// Along a way with so many fingers, and up.
    void draw(const QList<QPoint>& way, int fingers = 1) {
        press(way.front(), fingers);
        for (int i = 1; i < way.size(); ++i)
            go(way[i - 1], way[i], fingers);
        release(way.back(), fingers);
    }
    void press(QPoint place, int fingers = 1) {
        send(fingers, [&](auto& event, int finger) { event.press(finger, at(place, finger), &window_); });
    }
    void go(QPoint from, QPoint to, int fingers = 1) {
        constexpr int steps = 10;
        for (int step = 1; step <= steps; ++step) {
            send(fingers, [&](auto& event, int finger) { event.move(finger, at(from + (to - from) * step / steps, finger), &window_); });
            frame(); // movements come once in each
        }
    }
    void release(QPoint place, int fingers = 1) {
        send(fingers, [&](auto& event, int finger) { event.release(finger, at(place, finger), &window_); });
    }
    /// Until a next tap is not the second of a double tap.
    static void rest() { QTest::qWait(750); }

    /// The first one of this name that is seen.
    QQuickItem* item(const char* object_name) const {
        return below(*window_.contentItem(), object_name);
    }
    static QPoint middle_of(const QQuickItem& item) {
        return item.mapToScene({0.5 * item.width(), 0.5 * item.height()}).toPoint();
    }
    bool bring_into_view(QQuickItem& target) {
        for (int i = 0; i < 60; ++i) {
            QQuickItem* scroll = flickable_of(target);
            if (scroll == nullptr)
                return QRectF(QPointF(), window_.size()).contains(middle_of(target));
            const QRectF seen = scroll->mapRectToScene(scroll->boundingRect()) & QRectF(QPointF(), window_.size());
            const double below = middle_of(target).y() - seen.bottom() + 30.0, above = seen.top() + 30.0 - middle_of(target).y();
            if (below <= 0.0 && above <= 0.0)
                return true;
            const int way = static_cast<int>(std::min(0.6 * seen.height(), std::max(below, above) + 40.0)) * (below > 0.0 ? -1 : 1);
            const QPoint from(static_cast<int>(seen.left()) + 3, static_cast<int>(below > 0.0 ? seen.bottom() - 20.0 : seen.top() + 20.0));
            press(from);
            go(from, from + QPoint(0, way));
            QTest::qWait(150); // it rests before it is lifted, and throws nothing
            release(from + QPoint(0, way));
            if (!QTest::qWaitFor([&] { return !scroll->property("moving").toBool(); }))
                return false;
        }
        return false;
    }

private:
    void frame() {
        QSignalSpy drawn(&window_, &QQuickWindow::frameSwapped);
        window_.update();
        if (!drawn.wait())
            qFatal("no frame is drawn");
    }
    /// What has this name, when it is laid out and stays where it is.
    QQuickItem* resting(const QString& name) {
        QQuickItem* target = nullptr;
        QPoint before(-1, -1);
        const bool found = QTest::qWaitFor([&] {
            frame();
            target = find(name);
            return target != nullptr && std::exchange(before, middle_of(*target)) == middle_of(*target);
        }, patience_ms);
        return found ? target : nullptr;
    }
    static QQuickItem* below(const QQuickItem& root, const char* object_name) {
        for (QQuickItem* child : root.childItems())
            if (child->isVisible()) {
                if (child->objectName() == object_name)
                    return child;
                if (QQuickItem* found = below(*child, object_name); found != nullptr)
                    return found;
            }
        return nullptr;
    }
    static constexpr int patience_ms = 60000;

    static QPoint at(QPoint place, int finger) { return place + QPoint(0, 90 * finger); }
    template <typename Fill>
    void send(int fingers, Fill fill) {
        auto event = QTest::touchEvent(&window_, screen());
        for (int finger = 0; finger < fingers; ++finger)
            fill(event, finger);
        event.commit();
    }
    /// One for all tests: Qt keeps what it knows of a device for as long as the program runs.
    static QPointingDevice* screen() {
        static QPointingDevice* const made = QTest::createTouchDevice();
        return made;
    }
    QQuickItem* find(QString name) const {
        const bool goes_on = name.endsWith("…"), begins_otherwise = name.startsWith("…");
        for (QAccessibleInterface* one : PageWindow::everything(window_)) {
            auto* item = qobject_cast<QQuickItem*>(one->object());
            const QString text = one->text(QAccessible::Name);
            const bool same = text == name || (goes_on && text.startsWith(name.chopped(1))) || (begins_otherwise && text.endsWith(name.mid(1)));
            if (item != nullptr && same && item->isEnabled() && one->role() != QAccessible::StaticText && one->role() != QAccessible::Heading)
                return item;
        }
        return nullptr;
    }
    static QQuickItem* flickable_of(const QQuickItem& item) {
        for (QQuickItem* around = item.parentItem(); around != nullptr; around = around->parentItem())
            if (around->inherits("QQuickFlickable"))
                return around;
        return nullptr;
    }

    QQuickWindow& window_;
};
