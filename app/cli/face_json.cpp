// SPDX-License-Identifier: Apache-2.0
#include "app/cli/face_json.hpp"

#include "app/cli/json_number.hpp"
#include "app/cli/terminal.hpp"
#include "core/geometry/flatten.hpp"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>

namespace tp {

namespace {

constexpr FlattenTolerance dense{0.02, 2.0};  ///< px; far below what a net or a finger can tell
constexpr FlattenTolerance sparse{0.2, 10.0}; ///< for what is exact to some pixels

QJsonValue text_or_null(const std::string& text) {
    return text.empty() ? QJsonValue(QJsonValue::Null) : QJsonValue(QString::fromStdString(text));
}

QJsonArray points(const Contour& contour, const FlattenTolerance& tolerance) {
    QJsonArray array;
    for (const Vec2 p : flatten(contour, tolerance).points)
        array.append(QJsonArray{in_thousandths(p.x), in_thousandths(p.y)});
    return array;
}

QJsonObject by_name(const std::vector<Contour>& contours, const FlattenTolerance& tolerance) {
    QJsonObject object;
    for (const Contour& contour : contours)
        object.insert(QString::fromStdString(contour.name), points(contour, tolerance));
    return object;
}

QJsonObject json(const Face& face) {
    QJsonArray mended;
    for (const std::string& name : face.mended)
        mended.append(QString::fromStdString(name));
    QJsonObject quality;
    for (std::size_t i = 0; i < face.quality.size() && i < face.contours.size(); ++i) {
        if (std::find(face.mended.begin(), face.mended.end(), face.contours[i].name) != face.mended.end())
            continue;
        QJsonArray reasons;
        for (const std::string& reason : face.quality[i].reasons)
            reasons.append(QString::fromStdString(reason));
        quality.insert(
            QString::fromStdString(face.contours[i].name),
            QJsonObject{{"expected_error_percent", in_thousandths(face.quality[i].expected_error_percent)},
                        {"reasons", reasons}});
    }
    const Rect& box = face.box;
    return {{"box",
             QJsonArray{in_thousandths(box.min.x), in_thousandths(box.min.y), in_thousandths(box.width()), in_thousandths(box.height())}},
            {"score", in_thousandths(face.score)},
            {"contours", by_name(face.contours, dense)},
            {"extras", by_name(face.extras, sparse)},
            {"mended", mended},
            {"quality", quality},
            {"problem", text_or_null(face.problem)}};
}

} // namespace

QByteArray json_line(const std::string& photo, const Extraction& extraction) {
    QJsonArray faces;
    for (const Face& face : extraction.faces)
        faces.append(json(face));
    const ExtractionTimes& ms = extraction.milliseconds;
    const QJsonObject line{{"photo", QString::fromStdString(photo)},
                           {"width", extraction.width},
                           {"height", extraction.height},
                           {"turned_degrees", extraction.turned_degrees},
                           {"milliseconds", QJsonObject{{"decode", in_thousandths(ms.decode)},
                                                        {"detect", in_thousandths(ms.detect)},
                                                        {"landmarks", in_thousandths(ms.landmarks)},
                                                        {"edges", in_thousandths(ms.edges)},
                                                        {"contours", in_thousandths(ms.contours)}}},
                           {"faces", faces},
                           {"problem", text_or_null(extraction.problem)}};
    return compact_json(line);
}

} // namespace tp
