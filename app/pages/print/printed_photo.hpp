// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/work/latest_task.hpp"
#include "core/files/file_name.hpp"
#include "faces/base/face.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tp {

/// The photograph that is printed, and whose faces are in it: read on a thread of its own.
class PrintedPhoto final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(QString name READ name NOTIFY changed)
    Q_PROPERTY(bool looking READ looking NOTIFY changed)
    /// All of them, then each.
    Q_PROPERTY(QStringList faces READ faces NOTIFY changed)
public:
    /// What is read of a photograph.
    struct Subject {
        Extraction extraction;
        std::vector<std::string> names; ///< of its faces, empty where nobody knows
    };
    using Read = std::function<Subject(const std::filesystem::path& photo)>;
    /// Faces with a person's corrections, and names from the metadata.
    static Subject read_subject(const std::filesystem::path& photo);

    /// `read` is called on another thread, and must outlive the photograph.
    explicit PrintedPhoto(Read read);

    QString name() const { return QString::fromStdString(name_in_utf8(file_.filename())); }
    bool looking() const { return looking_; }
    QStringList faces() const;
    const std::filesystem::path& file() const { return file_; } ///< empty: none was opened
    const Subject& subject() const { return subject_; }

    void open(const std::filesystem::path& photo);

signals:
    void changed();
    /// Faces and names are there now, or why they are not.
    void taken();

private:
    Read read_;
    std::filesystem::path file_;
    bool looking_ = false;
    Subject subject_;
    LatestTask reading_; ///< last: it ends before what its work is for
};

} // namespace tp
