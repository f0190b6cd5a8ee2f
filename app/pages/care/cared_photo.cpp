// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/cared_photo.hpp"

#include "app/album/metadata/read_record.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/files/durable_file.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace tp {

void CaredPhoto::open(const PhotoPlace& place) {
    place_ = place;
    record_ = {};
    name_languages_.clear();
    emit opened();
    emit changed();
    if (is_open()) {
        steps_.use(*place_.keeper);
        read_again();
    }
}

void CaredPhoto::read_again() {
    if (is_open())
        go(
            place_, [](AlbumKeeper&, const std::filesystem::path&) { return std::string{}; }, [](const QString&) {});
}

void CaredPhoto::change(const PhotoPlace& place, PhotoStep step, KeeperSteps::Then then) {
    go(place, std::move(step), [this, photo = place.photo, then = std::move(then)](const QString& problem) {
        then(problem);
        emit touched(photo);
    });
}

void CaredPhoto::go(const PhotoPlace& place, PhotoStep step, KeeperSteps::Then then) {
    struct Known {
        PhotoRecord record;
        std::string unread; ///< why there is no record of a photograph that is there
        std::vector<NameLanguage> name_languages;
    };
    const auto known = std::make_shared<Known>();
    steps_.run(
        *place.keeper,
        [step = std::move(step), photo = place.photo, known](AlbumKeeper& keeper) {
            const std::string problem = step(keeper, photo);
            if (auto record = read_record(photo))
                known->record = *std::move(record);
            else if (!is_gone(photo))
                known->unread = record.error();
            known->name_languages = NameLanguages(keeper).all();
            return problem;
        },
        [this, place, known, then = std::move(then)](const QString& problem) {
            emit name_languages_read(place.keeper->album(), known->name_languages);
            const bool open = place.photo == place_.photo;
            if (open) {
                if (known->unread.empty())
                    record_ = known->record;
                name_languages_ = known->name_languages;
                emit changed();
            }
            then(problem);
            if (open && problem.isEmpty() && !known->unread.empty())
                emit unread(in_persons_language(known->unread));
        });
}

} // namespace tp
