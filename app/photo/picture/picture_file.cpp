// SPDX-License-Identifier: Apache-2.0
#include "app/photo/picture/picture_file.hpp"

#include "core/files/durable_file.hpp"

#include <QBuffer>
#include <QByteArray>
#include <QFileInfo>

#include <string>
#include <string_view>

namespace tp {

Result<std::filesystem::path> write_image(const std::filesystem::path& file, const QImage& image) {
    const auto problem = [&](const std::string& why) {
        return Error{"The picture " + file.string() + " could not be written: " + why};
    };
    const QByteArray format = QFileInfo(QString::fromStdString(file.string())).suffix().toLatin1();
    QImage marked = image;
    marked.setText(QStringLiteral("Software"),
                   QStringLiteral("TouchPhoto-drawing")); // other than a photograph that was taken
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!marked.save(&buffer, format.isEmpty() ? "png" : format.constData()))
        return problem("the picture is empty, or its ending is neither png nor jpg.");
    const std::string_view text(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    if (const std::string reason = replace_file(file, text); !reason.empty())
        return problem(reason);
    return file;
}

} // namespace tp
