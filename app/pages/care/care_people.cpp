// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/care_people.hpp"

#include "app/album/index/album_queries.hpp"

namespace tp {

QStringList CarePeople::known(const QString& typed) const {
    AlbumQueries queries = album_.queries();
    QStringList names;
    if (typed.trimmed().isEmpty()) {
        if (const auto topics = queries.topics("person", {}, most_offered))
            for (const TopicEntry& topic : *topics)
                names << QString::fromStdString(topic.name);
    } else if (const auto topics = queries.suggestions(typed.toStdString(), std::size_t{3} * most_offered)) {
        for (const TopicEntry& topic : *topics)
            if (topic.kind == "person" && names.size() < most_offered)
                names << QString::fromStdString(topic.name);
    }
    return names;
}

} // namespace tp
