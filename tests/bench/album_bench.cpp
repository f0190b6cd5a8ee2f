// SPDX-License-Identifier: Apache-2.0
// The album's index at 100, 10 000 and 100 000 photographs, at last with two faces grouped on each: album_bench
// [FOLDER [COUNT…]]. Albums are drawn
// in FOLDER (default: a temporary one) and kept there for the next time. Scan and questions of each size run
// in processes of their own, so that memory is that one's alone; the last columns are ratios of neighbouring
// sizes.
#include "app/album/check/album_check.hpp"
#include "app/album/grouping/group_worker.hpp"
#include "app/album/index/album_queries.hpp"
#include "app/album/index/album_scan.hpp"
#include "app/album/index/seen_photos.hpp"
#include "app/album/metadata/read_record.hpp"
#include "known_faces.hpp"
#include "synthetic_album.hpp"

#include <QCoreApplication>
#include <QProcess>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <string>

using namespace tp;
using namespace tp::testing;

namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Time that this thread was computing: on a busy machine the time on the wall is that of the others' work.
double cpu_ms() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

/// Of this process, in MB: "VmRSS:" now, "VmHWM:" at most so far.
double memory_mb(const std::string& which) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == which && status >> word)
            return std::stod(word) / 1024.0;
    return 0.0;
}

double percentile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Figures of one size by name, in the order in which they were measured.
using Figures = std::vector<std::pair<std::string, double>>;

/// What a person types: names and words letter by letter, alone and after another word.
std::vector<std::string> typed_texts() {
    SyntheticAlbum album(1);
    std::vector<std::string> texts;
    for (int i = 0; i < 60; ++i) {
        const std::string& text = i % 2 == 0 ? album.common(album.people()) : album.common(album.words());
        const std::string before = i % 3 == 0 ? album.common(album.words()) + " " : "";
        for (std::size_t length = 1; length <= text.size(); ++length)
            texts.push_back(before + text.substr(0, length));
    }
    return texts;
}

template <typename Ask>
std::vector<double> times(const std::vector<std::string>& texts, Ask ask) {
    std::vector<double> result;
    for (const std::string& text : texts) {
        const double begin = cpu_ms();
        benchmark::DoNotOptimize(ask(text));
        result.push_back(cpu_ms() - begin);
    }
    return result;
}

/// Scans, and adds what a photograph took.
void add_scan(Figures& figures, const std::string& name, const fs::path& album, const fs::path& cache,
              std::size_t count) {
    auto index = AlbumIndex::open(cache);
    ScanTools tools;
    tools.read_record = read_record;
    const auto begin = Clock::now();
    const double cpu_begin = cpu_ms();
    const auto report = scan_album(*index, {album}, tools);
    if (!report || report.value().found != count)
        std::exit(1);
    const auto photos = static_cast<double>(count);
    figures.emplace_back(name + ", ms per photograph", ms_since(begin) / photos);
    figures.emplace_back(name + ", CPU ms per photograph", (cpu_ms() - cpu_begin) / photos);
}

Figures scan_figures(const fs::path& folder, std::size_t count) {
    const fs::path album = folder / std::to_string(count), cache = folder / ("cache" + std::to_string(count));
    if (!fs::exists(album)) {
        const fs::path half = folder / "half";
        fs::remove_all(half);
        SyntheticAlbum(1).write(half, count);
        fs::rename(half, album);
    }
    if (!AlbumIndex::discard(cache).empty())
        std::exit(1);
    Figures figures;
    add_scan(figures, "first scan", album, cache, count);
    add_scan(figures, "scan without changes", album, cache, count);
    figures.emplace_back("memory of the scan at most, MB", memory_mb("VmHWM:"));
    return figures;
}

Figures page_figures(const fs::path& folder, std::size_t count) {
    Figures figures;
    const auto begin = Clock::now();
    auto index = AlbumIndex::open(folder / ("cache" + std::to_string(count)));
    AlbumQueries queries(*index);
    benchmark::DoNotOptimize(queries.page(AllByTime{}, {}, 50));
    figures.emplace_back("open and first page, ms", ms_since(begin));
    const std::vector<std::string> texts = typed_texts();
    const auto searches = times(texts, [&](const std::string& text) { return queries.search(text, 50); });
    for (const auto& [name, share] : {std::pair("p50", 0.5), std::pair("p95", 0.95), std::pair("max", 1.0)})
        figures.emplace_back("search as typed, " + std::string(name) + " CPU ms",
                             percentile(searches, share));
    const auto suggestions =
        times(texts, [&](const std::string& text) { return queries.suggestions(text, 8); });
    figures.emplace_back("suggestions, p95 CPU ms", percentile(suggestions, 0.95));
    std::uint64_t seed = 0;
    const auto anywhere = [&] { return queries.surprise(seed++).value()->place; };
    const auto pages =
        times(texts, [&](const std::string&) { return queries.page(AllByTime{}, anywhere(), 50); });
    figures.emplace_back("page of 50 anywhere, p95 CPU ms", percentile(pages, 0.95));
    figures.emplace_back("memory after all that, MB", memory_mb("VmRSS:"));
    return figures;
}

/// Two faces a photograph, of as many people as there are photographs of each.
void add_faces(AlbumIndex& index, std::size_t count) {
    std::vector<std::string> hashes;
    {
        SqlRun run =
            index.connection().run("SELECT DISTINCT lower(hex(hash)) FROM photos WHERE hash IS NOT NULL");
        while (run.next())
            hashes.push_back(run.text(0));
    }
    const int people = static_cast<int>(std::sqrt(static_cast<double>(count)));
    SeenPhotos seen(index, 1, true);
    unsigned next_face = 0;
    for (const std::string& hash : hashes) {
        Looked looked;
        looked.seen.width = looked.seen.height = 100;
        for (std::size_t place = 0; place < 2; ++place) {
            SeenFace face;
            face.part = place_of_face(place);
            looked.seen.faces.push_back(face);
            looked.marks.push_back(
                {NoGuess::none, numbers_of(static_cast<int>(next_face) % people, next_face)});
            next_face += place == 0 ? static_cast<unsigned>(people) + 1 : 2;
        }
        if (!seen.put(hash, looked).empty())
            std::exit(1);
    }
}

Figures face_figures(const fs::path& folder, std::size_t count) {
    Figures figures;
    const fs::path cache = folder / ("cache" + std::to_string(count));
    {
        auto index = AlbumIndex::open(cache);
        add_faces(*index, count);
        const double begin = cpu_ms();
        GroupWorker worker(*index);
        while (worker.group(1000).more) {
        }
        figures.emplace_back("two faces a photograph grouped, CPU ms", cpu_ms() - begin);
    }
    const auto begin = Clock::now();
    auto index = AlbumIndex::open(cache);
    benchmark::DoNotOptimize(AlbumQueries(*index).page(AllByTime{}, {}, 50));
    figures.emplace_back("then open and first page, ms", ms_since(begin));
    return figures;
}

/// All in one folder: photographs with a sidecar each, and as many sidecars of photographs that are gone.
Figures check_figures(const fs::path& folder, std::size_t count) {
    const fs::path album = folder / ("check" + std::to_string(count));
    if (!fs::exists(album)) {
        const fs::path half = folder / "half";
        fs::remove_all(half);
        fs::create_directories(half);
        SyntheticAlbum drawn(2);
        for (std::size_t i = 0; i < count; ++i) {
            drawn.write_photo(half / ("IMG_" + std::to_string(i) + ".jpg"), i);
            fs::copy_file(half / ("IMG_" + std::to_string(i) + ".jpg.xmp"),
                          half / ("GONE_" + std::to_string(i) + ".jpg.xmp"));
        }
        fs::rename(half, album);
    }
    const double begin = cpu_ms();
    const auto report = check_album(album);
    if (!report || report->photos != count || report->findings.size() != count)
        std::exit(1);
    return {{"check of three files a photograph, CPU ms a photograph",
             (cpu_ms() - begin) / static_cast<double>(count)},
            {"memory of the check at most, MB", memory_mb("VmHWM:")}};
}

void print(const Figures& figures) {
    for (const auto& [name, value] : figures)
        std::printf("%s\t%.6f\n", name.c_str(), value);
}

/// What this program prints when it is called so.
Figures of_process(const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start(QCoreApplication::applicationFilePath(), arguments);
    process.waitForFinished(-1);
    if (process.exitCode() != 0)
        std::exit(1);
    Figures figures;
    for (const QByteArray& line : process.readAllStandardOutput().trimmed().split('\n'))
        figures.emplace_back(line.split('\t').first().toStdString(), line.split('\t').last().toDouble());
    return figures;
}

/// A column for each size, and for each two neighbours how many times the larger one takes.
void print_table(const std::vector<std::string>& sizes, const std::vector<Figures>& columns) {
    std::printf("%-42s", "photographs");
    for (const std::string& size : sizes)
        std::printf("%12s", size.c_str());
    for (std::size_t i = 1; i < sizes.size(); ++i)
        std::printf("%12s", ("x " + sizes[i - 1] + "→").c_str());
    std::printf("\n");
    for (std::size_t row = 0; row < columns[0].size(); ++row) {
        std::printf("%-42s", columns[0][row].first.c_str());
        for (const Figures& column : columns)
            std::printf("%12.3f", column[row].second);
        for (std::size_t i = 1; i < columns.size(); ++i)
            std::printf("%12.2f", columns[i][row].second / columns[i - 1][row].second);
        std::printf("\n");
    }
}

} // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    const QStringList arguments = application.arguments();
    if (argc == 4 && arguments[1].startsWith("--")) {
        const auto figures = arguments[1] == "--scan"    ? scan_figures
                             : arguments[1] == "--pages" ? page_figures
                             : arguments[1] == "--check" ? check_figures
                                                         : face_figures;
        print(figures(argv[2], std::stoul(argv[3])));
        return 0;
    }
    const QTemporaryDir temporary;
    const QString folder = argc > 1 ? arguments[1] : temporary.path();
    std::vector<std::string> sizes(argv + std::min(argc, 2), argv + argc);
    if (sizes.empty())
        sizes = {"100", "10000", "100000"};
    std::vector<Figures> columns;
    for (const std::string& size : sizes) {
        columns.push_back(of_process({"--scan", folder, QString::fromStdString(size)}));
        for (const char* const what : {"--pages", "--check", "--faces"})
            for (auto& figure : of_process({what, folder, QString::fromStdString(size)}))
                columns.back().push_back(std::move(figure));
    }
    print_table(sizes, columns);
}
