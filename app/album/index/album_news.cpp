// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_news.hpp"

namespace tp {

Result<News> AlbumNews::news() {
    return index_.guarded([&] {
        SqlConnection& connection = index_.connection();
        std::int64_t last = 0;
        {
            SqlRun run = connection.run("SELECT last FROM told");
            last = run.next() ? run.integer(0) : 0;
        }
        News news;
        if (last == 0)
            return news;
        SqlRun run = connection.run(
            "SELECT count(*), coalesce(sum(EXISTS (SELECT 1 FROM seen_faces WHERE hash = p.hash)), 0), "
            "coalesce(sum(hash IS NOT NULL AND NOT EXISTS (SELECT 1 FROM looked WHERE hash = p.hash)), 0) "
            "FROM photos p WHERE p.id > ? AND p.missing = 0",
            last);
        if (run.next())
            news = {static_cast<std::size_t>(run.integer(0)), static_cast<std::size_t>(run.integer(1)),
                    static_cast<std::size_t>(run.integer(2))};
        return news;
    });
}

std::string AlbumNews::told() {
    const Result<bool> done = index_.guarded([&] {
        index_.connection().run("UPDATE told SET last = (SELECT coalesce(max(id), 0) FROM photos)");
        return true;
    });
    return done ? std::string() : done.error();
}

} // namespace tp
