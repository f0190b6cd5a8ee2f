// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "app/photo/seen/seen_photo.hpp"
#include "app/photo/towns/nearest_town.hpp"

#include <QDate>
#include <QLocale>
#include <QString>
#include <QStringList>
#include <QTime>

#include <cstddef>
#include <optional>
#include <vector>

namespace tp {

/// Where somebody is among those who are on a photograph.
struct Spot {
    enum class Kind { left, middle, right, above, below, far_left, from_left, far_right };
    Kind kind = Kind::middle;
    std::size_t number = 0; ///< of `from_left`, from 2 on

    bool operator==(const Spot&) const = default;
};

struct PersonShown {
    QString name; ///< empty: nobody said who it is
    Spot spot;
    bool further_back = false; ///< the face is less than half as high as the largest
    SeenFace face;             ///< of somebody whom only a person has seen, little
};

/// Everything that a sentence about a photograph is made of; no words but names.
struct PhotoView {
    bool seen = false;               ///< somebody has looked at it
    std::vector<PersonShown> people; ///< whose place is known, from left to right
    QStringList elsewhere;           ///< named without a place
    int width = 0, height = 0;       ///< px, upright; 0: unknown
    Nearness nearness = Nearness::usual;
    Light light = Light::usual;
    Colours colours = Colours::many;
    bool blurred = false;
    QDate date; ///< invalid: unknown
    QTime time; ///< likewise, as the camera had it
    QString town;
    NearTown::Where where = NearTown::Where::in;
    int km = 0; ///< from the town, where `where` is `from`; in tens
};

/// `seen`: nothing, where nobody has looked yet. A town is called as `language` has it, where it has a name for it.
PhotoView view_of(const std::optional<SeenPhoto>& seen, const PhotoRecord& record,
                  QLocale::Language language);

/// How many smile, as far as that is sure.
std::size_t smiling(const PhotoView& view);

enum class Shape { unknown, upright, square, wide, panorama };
Shape shape_of(const PhotoView& view);

} // namespace tp
