// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/narration/narrator.hpp"

#include <QObject>
#include <QString>

namespace tp {

/// How the lab says what it does; what goes on stays in sight.
class LabTeller final : public QObject {
    Q_OBJECT
public:
    /// The narrator must outlive it.
    explicit LabTeller(Narrator& narrator);

    /// What goes on, in a sentence.
    const QString& status() const { return status_; }

    /// An answer to what a hand does now.
    void tell(const QString& sentence) { narrator_.tell(sentence, Priority::touch); }
    /// Something that is to be heard to its end, and stays in sight.
    void say(const QString& sentence) { keep(sentence, Priority::message); }
    /// The same for what went wrong with a device.
    void warn(const QString& sentence) { keep(sentence, Priority::fault); }
    void silence() { narrator_.stop(); }

signals:
    void changed();

private:
    void keep(const QString& sentence, Priority priority);

    Narrator& narrator_;
    QString status_;
};

} // namespace tp
