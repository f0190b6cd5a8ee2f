// SPDX-License-Identifier: Apache-2.0
#include "app/photo/words/photo_view.hpp"

#include "app/photo/people/face_names.hpp"
#include "app/photo/people/region_place.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

QString plain(const std::string& text) { return QString::fromStdString(text).simplified(); }

std::vector<PersonShown> people_on(const SeenPhoto& seen, const PhotoRecord& record) {
    std::vector<Rect> parts;
    for (const SeenFace& face : seen.faces)
        parts.push_back(face.part);
    const NamedParts named = names_of_parts(parts, seen.turned_degrees, record);
    std::vector<PersonShown> people;
    for (std::size_t i = 0; i < parts.size(); ++i)
        people.push_back({plain(named.names[i]), {}, false, seen.faces[i]});
    for (const std::size_t region : named.regions_without) {
        SeenFace face;
        face.part = shown_part(record.faces[region], {record.orientation, seen.turned_degrees});
        people.push_back({plain(record.faces[region].name), {}, false, face});
    }
    std::stable_sort(people.begin(), people.end(), [](const PersonShown& a, const PersonShown& b) {
        return a.face.part.centre().x < b.face.part.centre().x;
    });
    return people;
}

void say_spots(std::vector<PersonShown>& people) {
    using Kind = Spot::Kind;
    constexpr double third = 1.0 / 3.0, one_above_other = 0.12;
    const std::size_t count = people.size();
    const auto x = [&](std::size_t i) { return people[i].face.part.centre().x; };
    const auto y = [&](std::size_t i) { return people[i].face.part.centre().y; };
    if (count == 1)
        people[0].spot.kind = x(0) < third ? Kind::left : x(0) > 1.0 - third ? Kind::right : Kind::middle;
    else if (count == 2 && x(1) - x(0) < one_above_other && std::abs(y(1) - y(0)) > x(1) - x(0)) {
        people[0].spot.kind = y(0) < y(1) ? Kind::above : Kind::below;
        people[1].spot.kind = y(0) < y(1) ? Kind::below : Kind::above;
    } else
        for (std::size_t i = 0; i < count; ++i) {
            const bool first = i == 0, last = i + 1 == count;
            if (count <= 3)
                people[i].spot.kind = first ? Kind::left : last ? Kind::right : Kind::middle;
            else
                people[i].spot = {first ? Kind::far_left : last ? Kind::far_right : Kind::from_left, i + 1};
        }
}

void say_depth(std::vector<PersonShown>& people) {
    double highest = 0.0;
    for (const PersonShown& person : people)
        highest = std::max(highest, person.face.part.height());
    for (PersonShown& person : people)
        person.further_back = person.face.part.height() < 0.5 * highest;
}

/// A camera's clock knows no more than its owner set; midnight to the second is a date alone.
void say_time(PhotoView& view, const std::string& taken) {
    const QString text = QString::fromStdString(taken);
    view.date = QDate::fromString(text.left(10), Qt::ISODate);
    view.time = QTime::fromString(text.mid(11, 5), QStringLiteral("HH:mm"));
    if (!view.date.isValid() ||
        (view.time == QTime(0, 0) && text.mid(16, 3).remove(QLatin1Char(':')).toInt() == 0))
        view.time = QTime();
}

void say_place(PhotoView& view, const PhotoRecord& record, QLocale::Language language) {
    view.town = plain(record.place_name).section(QStringLiteral(", "), 0, 0);
    if (!view.town.isEmpty() || !record.place)
        return;
    const std::optional<NearTown> near = nearest_town(record.place->latitude, record.place->longitude);
    if (!near)
        return;
    const std::string_view own = language == QLocale::German   ? near->town->german
                                 : language == QLocale::Korean ? near->town->korean
                                                               : std::string_view();
    const std::string_view name = own.empty() ? near->town->name : own;
    view.town = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    view.where = near->where;
    view.km = 10 * static_cast<int>(std::lround(near->distance_km / 10.0));
}

} // namespace

PhotoView view_of(const std::optional<SeenPhoto>& seen, const PhotoRecord& record,
                  QLocale::Language language) {
    PhotoView view;
    view.seen = seen && seen->width > 0 && seen->height > 0;
    const SeenPhoto photo = view.seen ? *seen : SeenPhoto();
    view.people = people_on(photo, record);
    say_spots(view.people);
    say_depth(view.people);
    for (const std::string& person : record.persons)
        if (const QString name = plain(person);
            !name.isEmpty() && std::none_of(view.people.begin(), view.people.end(),
                                            [&](const PersonShown& shown) { return shown.name == name; }))
            view.elsewhere << name;
    view.width = photo.width;
    view.height = photo.height;
    view.nearness = photo.faces.empty() ? Nearness::usual : nearness_of(photo);
    view.light = photo.light;
    view.colours = photo.colours;
    view.blurred = photo.blurred;
    say_time(view, record.taken);
    say_place(view, record, language);
    return view;
}

std::size_t smiling(const PhotoView& view) {
    return static_cast<std::size_t>(
        std::count_if(view.people.begin(), view.people.end(), [](const PersonShown& person) {
            return person.face.mien != Mien::unknown && person.face.mien != Mien::perhaps_smiling;
        }));
}

Shape shape_of(const PhotoView& view) {
    if (view.width <= 0 || view.height <= 0)
        return Shape::unknown;
    const double ratio = static_cast<double>(view.width) / view.height;
    return ratio < 0.9    ? Shape::upright
           : ratio <= 1.1 ? Shape::square
           : ratio < 2.2  ? Shape::wide
                          : Shape::panorama;
}

} // namespace tp
