// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_activity.hpp"
#include "app/pages/lab/lab_setup.hpp"
#include "app/pages/lab/lab_teller.hpp"

#include <QObject>
#include <QQmlPropertyMap>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <vector>

namespace tp {

/// Everything that can be turned: each change is told and can be taken back.
class LabTuning final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(int law READ law NOTIFY changed) ///< index into `laws`
    Q_PROPERTY(QStringList laws READ laws NOTIFY changed)
    /// Every number and switch of LabParameters by its key.
    Q_PROPERTY(QQmlPropertyMap* values READ values CONSTANT)
    /// What undo() takes back, in words; empty: nothing.
    Q_PROPERTY(QString undoable READ undoable NOTIFY changed)
public:
    /// Both must outlive it.
    LabTuning(LabActivity& activity, LabTeller& teller);

    int law() const { return static_cast<int>(parameters_.law); }
    QStringList laws() const;
    QQmlPropertyMap* values() { return &values_; }
    QString undoable() const { return history_.empty() ? QString() : history_.back().what; }
    const LabParameters& parameters() const { return parameters_; }

    Q_INVOKABLE void chooseLaw(int index);
    /// `label` is what the page calls it, for the ear.
    Q_INVOKABLE void setNumber(const QString& key, double value, const QString& label);
    Q_INVOKABLE void setSwitch(const QString& key, bool on, const QString& label);
    Q_INVOKABLE double lowest(const QString& key) const;
    Q_INVOKABLE double highest(const QString& key) const;
    Q_INVOKABLE double step(const QString& key) const;
    /// A value with its unit.
    Q_INVOKABLE QString words(const QString& key, double value) const;
    Q_INVOKABLE void reset();
    Q_INVOKABLE void undo();

signals:
    void changed();
    /// What is felt is another scene now. Comes before `turned`.
    void sceneTurned();
    /// The parameters are others; whether device and loop must be made anew for that.
    void turned(bool anew);

private:
    struct Step {
        QString what;
        LabParameters before;
    };
    void make(const QString& what, const QString& said, const std::function<void(LabParameters&)>& change);
    void take(const LabParameters& parameters);

    LabActivity& activity_;
    LabTeller& teller_;
    LabParameters parameters_;
    QQmlPropertyMap values_;
    std::vector<Step> history_;
};

} // namespace tp
