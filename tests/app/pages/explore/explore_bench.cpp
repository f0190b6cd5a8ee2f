// SPDX-License-Identifier: Apache-2.0
#include "explore_bench.hpp"

#include "audio/sound/earcons.hpp"

#include <QColor>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace tp;

namespace {

Contour square(const char* name, Vec2 centre, double half_width, double half_height) {
    const Vec2 right(half_width, 0.0);
    const Vec2 down(0.0, half_height);
    return contour_through(
        name, {centre - right - down, centre + right - down, centre + right + down, centre - right + down},
        true);
}

Face drawn_face(Vec2 centre) {
    Face face;
    face.box = {centre - Vec2(30.0, 30.0), centre + Vec2(30.0, 30.0)};
    face.score = 1.0;
    face.contours = {square(feature::left_eye, centre + Vec2(15.0, -15.0), 6.0, 3.0),
                     square(feature::right_eye, centre + Vec2(-15.0, -15.0), 6.0, 3.0),
                     square(feature::outer_lip, centre + Vec2(0.0, 12.0), 10.0, 4.0),
                     contour_through(feature::outline,
                                     {centre + Vec2(-28.0, -15.0), centre + Vec2(-28.0, 28.0),
                                      centre + Vec2(28.0, 28.0), centre + Vec2(28.0, -15.0)},
                                     false)};
    return face;
}

} // namespace

std::shared_ptr<const LoadedPhoto> drawn_photo(int faces, std::vector<QString> names) {
    auto photo = std::make_shared<LoadedPhoto>();
    photo->name = "drawn.png";
    photo->image = QImage(200, 150, QImage::Format_RGB32);
    photo->image.fill(QColor(90, 110, 130));
    photo->extraction.width = 200;
    photo->extraction.height = 150;
    for (int i = 0; i < faces; ++i)
        photo->extraction.faces.push_back(drawn_face({200.0 * (i + 0.5) / faces, 75.0}));
    photo->names = std::move(names);
    return photo;
}

ExploreSettings patient_settings() {
    ExploreSettings settings;
    for (ServoSettings* servo : {&settings.servo, &settings.device_servo}) {
        servo->limits.stall = 60.0;
        servo->limits.stale_after = 60.0;
        servo->limits.late_periods = 60000.0;
        servo->limits.max_speed = 1e9;
    }
    return settings;
}

ExploreSettings settings_at(const double& time) {
    ExploreSettings settings = patient_settings();
    settings.now = [&time] { return time; };
    return settings;
}

double ExploreSounds::guide_peak(double seconds) {
    guide_output.heard.clear();
    guide_output.play(seconds);
    float most = 0.0F;
    for (const float sample : guide_output.heard)
        most = std::max(most, std::abs(sample));
    return most;
}

bool ExploreSounds::hears(Earcon earcon) {
    earcon_output.heard.clear();
    earcon_output.play(0.3);
    const auto sound = samples_of(earcon);
    return std::search(earcon_output.heard.begin(), earcon_output.heard.end(), sound.begin(), sound.end()) !=
           earcon_output.heard.end();
}

double distance_to_feature(const ExploreSession& session, int feature, QPointF place) {
    return distance_to(session.view()->felt().lines.at(static_cast<std::size_t>(feature)),
                       session.view()->frame().to_surface(place));
}
