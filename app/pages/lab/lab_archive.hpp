// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_activity.hpp"
#include "app/pages/lab/lab_files.hpp"
#include "app/pages/lab/lab_measurements.hpp"
#include "app/pages/lab/lab_run.hpp"
#include "app/pages/lab/lab_teller.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <filesystem>

namespace tp {

/// The lab's folder: recordings and tables that are made in it, each with its setup beside it.
class LabArchive final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(QString folder READ folder CONSTANT)
    /// Names of the recordings in the folder, the newest first.
    Q_PROPERTY(QStringList recordings READ recordings NOTIFY changed)
public:
    /// The folder is made when it is needed. The others must outlive it.
    LabArchive(const std::filesystem::path& folder, LabActivity& activity, LabRun& run,
               const LabMeasurements& measurements, LabTeller& teller);

    QString folder() const { return files_.folder_words(); }
    QStringList recordings() const { return files_.recordings(); }
    std::filesystem::path recording(const QString& name) const { return files_.recording(name); }

    Q_INVOKABLE void toggleRecording();
    Q_INVOKABLE void writeTable();
    /// A recording has ended; what became of it, in a sentence.
    QString finish(bool whole);

signals:
    void changed();

private:
    bool make_folder();

    LabFiles files_;
    LabActivity& activity_;
    LabRun& run_;
    const LabMeasurements& measurements_;
    LabTeller& teller_;
    std::filesystem::path recorded_;
};

} // namespace tp
