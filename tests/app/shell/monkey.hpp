// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/folders/folder_chooser.hpp"
#include "page_window.hpp"
#include "whole_program.hpp"

#include <QAccessible>
#include <QList>
#include <QObject>
#include <QPoint>
#include <QPointingDevice>
#include <QString>
#include <QStringList>
#include <QTest>

#include <cstddef>
#include <iterator>
#include <random>
#include <vector>

/// Somebody who touches, types and acts at random; the same for the same seed.
class Monkey {
public:
    Monkey(WholeProgram& whole, unsigned seed) : whole_(whole), random_(seed) {
        for (tp::FolderChooser* chooser :
             {whole.program->start().questions()->chooser(), whole.program->care().folders()->chooser(),
              whole.program->settings().storage()->chooser()})
            keep_at_home(*chooser);
    }

    void do_something() {
        switch (below(4)) {
        case 0:
            return touch();
        case 1:
            return key();
        case 2:
            return letter();
        default:
            return act();
        }
    }
    const QString& last() const { return last_; }

private:
    static constexpr int fast_keys[] = {
        Qt::Key_Tab,   Qt::Key_Backtab, Qt::Key_Left,  Qt::Key_Right,     Qt::Key_Up,    Qt::Key_Down,
        Qt::Key_Space, Qt::Key_Return,  Qt::Key_Home,  Qt::Key_End,       Qt::Key_F1,    Qt::Key_F2,
        Qt::Key_F3,    Qt::Key_Plus,    Qt::Key_Minus, Qt::Key_Backspace, Qt::Key_Escape};

    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    /// The folders of whoever runs this are not the monkey's: it could fill them, empty them, or read the
    /// whole computer.
    void keep_at_home(tp::FolderChooser& chooser) {
        const QString home = whole_.folder.path();
        QObject::connect(&chooser, &tp::FolderChooser::moved, [&chooser, home] {
            if (!(chooser.folder() + '/').startsWith(home + '/'))
                chooser.begin_in(home);
        });
    }
    QPoint place() { return {below(whole_.window->width()), below(whole_.window->height())}; }

    void touch() {
        const int fingers = 1 + below(3);
        last_ = QString("%1 finger(s)").arg(fingers);
        std::vector<QPoint> at;
        for (int i = 0; i < fingers; ++i)
            at.push_back(place());
        send([&](auto& event) {
            for (int i = 0; i < fingers; ++i)
                event.press(i, at[static_cast<std::size_t>(i)]);
        });
        if (below(2) == 0)
            send([&](auto& event) {
                for (int i = 0; i < fingers; ++i)
                    event.move(i,
                               at[static_cast<std::size_t>(i)] += QPoint(below(200) - 100, below(200) - 100));
            });
        send([&](auto& event) {
            for (int i = 0; i < fingers; ++i)
                event.release(i, at[static_cast<std::size_t>(i)]);
        });
    }
    /// One for all: Qt never lets a device go.
    static QPointingDevice* screen() {
        static QPointingDevice* const screen = QTest::createTouchDevice();
        return screen;
    }
    template <typename Fill>
    void send(Fill fill) {
        auto event = QTest::touchEvent(whole_.window.get(), screen(), false);
        fill(event);
        event.commit();
    }
    void key() {
        const int key = fast_keys[below(std::size(fast_keys))];
        last_ = QString("key %1").arg(key);
        QTest::keyClick(whole_.window.get(), static_cast<Qt::Key>(key),
                        below(8) == 0 ? Qt::ShiftModifier : Qt::NoModifier);
    }
    void letter() {
        const auto letter = static_cast<Qt::Key>(Qt::Key_0 + below(10));
        const auto key = below(2) == 0 ? letter : static_cast<Qt::Key>(Qt::Key_A + below(26));
        if (key == Qt::Key_O) // the system's own file dialog is not ours to drive
            return;
        last_ = QString("key %1").arg(key);
        QTest::keyClick(whole_.window.get(), key);
    }
    void act() {
        const QList<QAccessibleInterface*> all = PageWindow::everything(*whole_.window);
        QAccessibleInterface* one = all[below(static_cast<int>(all.size()))];
        const QString name = one->text(QAccessible::Name);
        if (one->actionInterface() == nullptr || opens_a_dialog(name))
            return;
        const QStringList actions = one->actionInterface()->actionNames();
        if (actions.isEmpty())
            return;
        last_ = actions[below(static_cast<int>(actions.size()))] + " " + name;
        one->actionInterface()->doAction(last_.section(' ', 0, 0));
    }
    static bool opens_a_dialog(const QString& name) { return name.endsWith("…"); }

    WholeProgram& whole_;
    std::mt19937 random_;
    QString last_;
};
