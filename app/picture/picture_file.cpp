// SPDX-License-Identifier: Apache-2.0
#include "app/picture/picture_file.hpp"

#include <QFileInfo>
#include <QSaveFile>

#include <string>

namespace tp {

Result<std::filesystem::path> write_image(const std::filesystem::path& file, const QImage& image) {
    const QString name = QString::fromStdString(file.string());
    const auto problem = [&](const std::string& why) {
        return Error{"The picture " + file.string() + " could not be written: " + why + "."};
    };
    QSaveFile out(name);
    if (!out.open(QIODevice::WriteOnly))
        return problem(out.errorString().toStdString());
    const QByteArray format = QFileInfo(name).suffix().toLatin1();
    if (!image.save(&out, format.isEmpty() ? "png" : format.constData()))
        return problem("the picture is empty, or its ending is neither png nor jpg");
    if (!out.commit())
        return problem(out.errorString().toStdString());
    return file;
}

} // namespace tp
