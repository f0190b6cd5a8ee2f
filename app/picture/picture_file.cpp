// SPDX-License-Identifier: Apache-2.0
#include "app/picture/picture_file.hpp"

#include <QFileInfo>
#include <QSaveFile>

namespace tp {

Result<std::filesystem::path> write_image(const std::filesystem::path& file, const QImage& image) {
    const QString name = QString::fromStdString(file.string());
    const auto problem = [&](const QString& why) {
        return Error{QStringLiteral("The picture %1 could not be written: %2.").arg(name, why).toStdString()};
    };
    QSaveFile out(name);
    if (!out.open(QIODevice::WriteOnly))
        return problem(out.errorString());
    const QByteArray format = QFileInfo(name).suffix().toLatin1();
    if (!image.save(&out, format.isEmpty() ? "png" : format.constData()))
        return problem(QStringLiteral("the picture is empty, or its ending is neither png nor jpg"));
    if (!out.commit())
        return problem(out.errorString());
    return file;
}

} // namespace tp
