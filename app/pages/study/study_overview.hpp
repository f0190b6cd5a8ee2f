// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/study/study_setup.hpp"
#include "app/pages/study/study_teller.hpp"
#include "app/parts/work/latest_task.hpp"

#include <QObject>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <filesystem>

namespace tp {

/// How the study that is set up stands, for the researcher who asks: the numbers so far, each participant, what is wrong in the
/// folder; and its report. Who asks is beside the set-up; a participant never hears or sees it, because it is hidden before a sitting
/// begins.
class StudyOverview final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    /// A sentence each; empty until somebody asks, and hidden again.
    Q_PROPERTY(QStringList lines READ lines NOTIFY changed)
public:
    /// Both must outlive it.
    StudyOverview(const StudySetup& setup, StudyTeller& teller);

    const QStringList& lines() const { return lines_; }

    /// Reads the folder, every path in it too, and tells how it stands.
    Q_INVOKABLE void look();
    /// Writes tables, plots and a page beside the study's folder and tells where.
    Q_INVOKABLE void makeReport();
    /// Nothing of it is to be seen any more, and what was asked for is not answered.
    void hide();

signals:
    void changed();

private:
    /// "…/primitives report"
    static std::filesystem::path report_folder(const std::filesystem::path& study);
    void show(QStringList lines);

    const StudySetup& setup_;
    StudyTeller& teller_;
    QStringList lines_;
    std::filesystem::path folder_; ///< that the lines speak of
    LatestTask reading_;           ///< last: its work ends first
};

} // namespace tp
