// SPDX-License-Identifier: Apache-2.0
/// Faces of an album grouped beside other work: 2 000 and 20 000 of them, two a photograph, of as many people as there are
/// photographs of one person. Time on the wall, and what pages ask of the groups afterwards.
#include "app/album/grouping/group_worker.hpp"
#include "app/album/index/photo_store.hpp"
#include "app/album/index/seen_photos.hpp"
#include "known_faces.hpp"

#include <QCoreApplication>

#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace tp;

namespace {

void check(const std::string& problem) {
    if (!problem.empty()) {
        std::fprintf(stderr, "%s\n", problem.c_str());
        std::exit(1);
    }
}

std::string hash_of(int photo) {
    std::string hash(32, '\0');
    for (std::size_t i = 0; i < 4; ++i)
        hash[i] = static_cast<char>(static_cast<unsigned>(photo) * 2654435761U >> (8 * i)); // in no order
    return hash;
}

/// An index of so many faces that nobody has grouped.
AlbumIndex index_with(int faces) {
    AlbumIndex index = std::move(AlbumIndex::in_memory()).value();
    const int photos = faces / 2;
    const int people = static_cast<int>(std::sqrt(faces));
    {
        SqlTransaction all(index.connection());
        put_folder(index.connection(), "/album", "x");
        for (int photo = 0; photo < photos; ++photo) {
            PhotoFacts facts;
            facts.folder = "/album";
            facts.listed.name = "IMG_" + std::to_string(photo) + ".jpg";
            facts.listed.modified_ns = std::int64_t{1'000'000'000} * 86'400 * photo;
            facts.sha256 = hash_of(photo);
            put_photo(index.connection(), facts);
        }
        all.commit();
    }
    SeenPhotos seen(index, 1, true);
    for (int photo = 0; photo < photos; ++photo) {
        Looked looked;
        looked.seen.width = looked.seen.height = 100;
        for (int i = 0; i < 2; ++i) {
            SeenFace face;
            face.part = testing::place_of_face(static_cast<std::size_t>(i));
            looked.seen.faces.push_back(face);
            looked.marks.push_back(
                {NoGuess::none, testing::numbers_of((photo + i * (photo / people + 1)) % people,
                                                    static_cast<unsigned>(2 * photo + i))});
        }
        std::string sha256;
        for (const char c : hash_of(photo)) {
            constexpr const char* digits = "0123456789abcdef";
            sha256 += {digits[static_cast<unsigned char>(c) >> 4], digits[c & 15]};
        }
        check(seen.put(sha256, looked));
    }
    return index;
}

void group_all(GroupWorker& worker) {
    while (worker.group(100).more) {
    }
}

void grouping(benchmark::State& state) {
    for (auto _ : state) {
        state.PauseTiming();
        const AlbumIndex index = index_with(static_cast<int>(state.range(0)));
        GroupWorker worker(index);
        state.ResumeTiming();
        group_all(worker);
    }
}
BENCHMARK(grouping)->Arg(2'000)->Arg(20'000)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

/// After a start of the program: what is kept is read, and all people are listed.
void people(benchmark::State& state) {
    const AlbumIndex index = index_with(static_cast<int>(state.range(0)));
    {
        GroupWorker worker(index);
        group_all(worker);
    }
    for (auto _ : state) {
        GroupWorker worker(index);
        const People found = worker.people();
        state.counters["people"] = static_cast<double>(found.persons.size());
    }
}
BENCHMARK(people)->Arg(2'000)->Arg(20'000)->Unit(benchmark::kMillisecond)->UseRealTime();

void one_more_photo(benchmark::State& state) {
    const AlbumIndex index = index_with(static_cast<int>(state.range(0)));
    GroupWorker worker(index);
    group_all(worker);
    Result<AlbumIndex> another = index.another();
    for (auto _ : state) {
        another->connection().run("INSERT OR IGNORE INTO to_group SELECT hash FROM known_faces LIMIT 1");
        worker.group(100);
    }
}
BENCHMARK(one_more_photo)->Arg(2'000)->Arg(20'000)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
