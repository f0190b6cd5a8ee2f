// SPDX-License-Identifier: Apache-2.0
#include "mend_bench.hpp"

#include "core/svg/contour_sheet.hpp"
#include "faces/pieces/contour_fit.hpp"

#include <QColor>

using namespace tp;

namespace {

Contour almond(const char* name, Vec2 middle, double half_width, double half_height) {
    const auto at = [&](double x, double y) { return middle + Vec2(x * half_width, y * half_height); };
    return fit_contour(name, {at(-1, 0), at(-0.5, -0.8), at(0, -1), at(0.5, -0.8), at(1, 0), at(0.5, 0.8), at(0, 1), at(-0.5, 0.8)},
                       true, {0, 4});
}

} // namespace

Extraction drawn_extraction(int faces) {
    Extraction extraction;
    extraction.width = 400;
    extraction.height = 300;
    for (int i = 0; i < faces; ++i) {
        const Vec2 middle(400.0 * (i + 0.5) / faces, 150.0);
        Face face;
        face.box = {middle - Vec2(70, 100), middle + Vec2(70, 100)};
        face.score = 1.0;
        face.contours = {almond(feature::left_eye, middle + Vec2(30, -30), 18, 8),
                         almond(feature::right_eye, middle + Vec2(-30, -30), 18, 8),
                         almond(feature::outer_lip, middle + Vec2(0, 50), 30, 10),
                         fit_contour(feature::outline,
                                     {middle + Vec2(-65, -20), middle + Vec2(-55, 50), middle + Vec2(0, 95),
                                      middle + Vec2(55, 50), middle + Vec2(65, -20)},
                                     false)};
        face.extras = {fit_contour(feature::nose, {middle + Vec2(-15, 15), middle + Vec2(0, 22), middle + Vec2(15, 15)}, false)};
        face.quality.resize(face.contours.size());
        extraction.faces.push_back(std::move(face));
    }
    return extraction;
}

MendPhoto drawn_mend_photo(const QString& folder, int faces) {
    const QString file = folder + "/drawn.png";
    const Extraction found = drawn_extraction(faces);
    MendPhoto photo;
    photo.file = file;
    photo.image = QImage(400, 300, QImage::Format_RGB32);
    photo.image.fill(QColor(90, 110, 130));
    photo.work = work_on(found, with_corrections(found, file.toStdString()));
    photo.contours = MendFile::open(file.toStdString(), photo.work).value();
    photo.usable = true;
    return photo;
}
