// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_files.hpp"

#include "core/files/durable_file.hpp"
#include "core/files/free_name.hpp"

#include <QDateTime>
#include <QDir>

#include <algorithm>

namespace tp {

std::string LabFiles::make_folder() const { return tp::make_folder(folder_); }

QString LabFiles::path_words(const std::filesystem::path& file) {
    return QDir::toNativeSeparators(QString::fromStdString(file.string()));
}

QStringList LabFiles::recordings() const {
    QStringList names =
        QDir(QString::fromStdString(folder_.string())).entryList({"*.touch"}, QDir::Files, QDir::Name);
    std::reverse(names.begin(), names.end());
    return names;
}

Result<std::filesystem::path> LabFiles::new_file(const char* ending) const {
    const QString stamp = QDateTime::currentDateTime().toString("'lab-'yyyyMMdd'-'HHmmss");
    return free_name([&](int number) {
        const QString name = number == 1 ? stamp : QString("%1-%2").arg(stamp).arg(number);
        std::vector<std::filesystem::path> names{recording(name + ending)};
        for (const char* kind : {".touch", ".csv", ".json"})
            names.push_back(recording(name + kind));
        return names;
    });
}

} // namespace tp
