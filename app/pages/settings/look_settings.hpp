// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/settings/setting_steps.hpp"

#include <QObject>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// Who uses the program, and what it looks like.
class LookSettings final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    // Each of these is an index into the options of its name.
    Q_PROPERTY(int user READ user NOTIFY changed)
    Q_PROPERTY(QStringList users READ users NOTIFY changed)
    Q_PROPERTY(int theme READ theme NOTIFY changed)
    Q_PROPERTY(QStringList themes READ themes NOTIFY changed)

    Q_PROPERTY(double textScale READ textScale NOTIFY changed)
    Q_PROPERTY(bool motion READ motion NOTIFY changed)
public:
    /// They must outlive it.
    explicit LookSettings(SettingSteps& steps);

    int user() const { return static_cast<int>(steps_.now().user); }
    QStringList users() const;
    int theme() const { return static_cast<int>(steps_.now().theme); }
    QStringList themes() const;
    double textScale() const { return steps_.now().text_scale; }
    bool motion() const { return steps_.now().motion; }

    Q_INVOKABLE void chooseUser(int index);
    Q_INVOKABLE void chooseTheme(int index);
    Q_INVOKABLE void setTextScale(double scale);
    Q_INVOKABLE void setMotion(bool on);

signals:
    void changed();

private:
    SettingSteps& steps_;
};

} // namespace tp
