// SPDX-License-Identifier: Apache-2.0
// Whatever happens to an album, a scan that reads what changed knows what a scan of everything knows.
#include "test_album.hpp"
#include "test_program.hpp"

#include <QTest>

#include <set>

namespace scan_property_test {

using namespace tp;
using namespace tp::testing;

namespace {

/// Does to an album what people and other programs do to one.
class Changes {
public:
    Changes(const fs::path& root, std::uint64_t seed) : root_(root), made_(seed) {}

    /// One random change; notes the folders in which something happened.
    void make() {
        const std::vector<fs::path> photos = files(".jpg");
        const fs::path photo = photos.empty() ? fs::path() : photos[made_.below(photos.size())];
        const std::size_t what = photos.empty() ? 0 : made_.below(13);
        const fs::path other = folder() / ("IMG_" + std::to_string(made_.below(30)) + ".jpg");
        switch (what) {
        case 0:
        case 1:
        case 2:
            if (!fs::exists(other))
                made_.write_photo(other, made_.below(20)); // some of them duplicates
            note(other);
            break;
        case 3:
            fs::remove(photo);
            note(photo);
            break;
        case 4:
        case 5:
            if (!fs::exists(other))
                fs::rename(photo, other); // its sidecar stays behind
            note(photo);
            note(other);
            break;
        case 6:
            write_file(photo, jpeg_bytes("anew " + std::to_string(made_.below(1000))));
            note(photo);
            break;
        case 7:
        case 8:
            write_file(photo.string() + ".xmp", sidecar_text(made_.record()));
            note(photo);
            break;
        case 9:
            fs::remove(photo.string() + ".xmp");
            note(photo);
            break;
        case 10: {
            const fs::path recordings = photo.string() + ".tags";
            fs::create_directory(recordings);
            write_file(recordings / (std::to_string(made_.below(3)) + ".flac"), made_.record().place_name);
            note(photo);
            break;
        }
        case 11:
            move_folder();
            break;
        default:
            fs::last_write_time(photo,
                                fs::file_time_type::clock::now() - std::chrono::hours(made_.below(100'000)));
            note(photo);
        }
    }

    std::vector<fs::path> changed_folders() { return {changed_.begin(), changed_.end()}; }

private:
    void note(const fs::path& photo) { changed_.insert(photo.parent_path()); }

    std::vector<fs::path> files(std::string_view extension) const {
        std::set<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(root_))
            if (entry.path().extension() == extension)
                found.insert(entry.path());
        return {found.begin(), found.end()};
    }

    fs::path folder() {
        fs::path path = root_;
        for (std::size_t i = made_.below(3); i > 0; --i) {
            changed_.insert(path);
            path /= "folder " + std::to_string(made_.below(3));
            fs::create_directory(path);
        }
        return path;
    }

    void move_folder() {
        const fs::path from = folder();
        const fs::path to = folder() / ("moved " + std::to_string(made_.below(100)));
        if (from == root_ || to.native().starts_with(from.native()) || fs::exists(to))
            return;
        fs::rename(from, to);
        changed_.insert({from.parent_path(), to.parent_path()});
        std::erase_if(changed_,
                      [&](const fs::path& path) { return path.native().starts_with(from.native() + "/"); });
    }

    fs::path root_;
    SyntheticAlbum made_;
    std::set<fs::path> changed_;
};

} // namespace

class ScanPropertyTest : public QObject {
    Q_OBJECT

private slots:
    void a_scan_of_changes_knows_what_a_scan_of_everything_knows() {
        for (std::uint64_t seed = 0; seed < 12; ++seed) {
            TestAlbum album;
            auto index = AlbumIndex::open(album.cache());
            SyntheticAlbum numbers(seed + 100);
            for (int round = 0; round < 12; ++round) {
                Changes changes(album.root(), seed * 1000 + static_cast<std::uint64_t>(round));
                for (std::size_t i = numbers.below(12); i > 0; --i)
                    changes.make();
                if (numbers.below(4) == 0)
                    QVERIFY(forgets_missing(*index));
                const auto report = numbers.below(2) == 0
                                        ? rescan_folders(*index, changes.changed_folders(), album.tools)
                                        : album.scan(*index);
                QVERIFY2(report.ok(), report.error().c_str());
                if (index->dump().value() != album.fresh_dump())
                    qWarning("seed %llu, round %d", static_cast<unsigned long long>(seed), round);
                QCOMPARE(index->dump().value(), album.fresh_dump());
            }
            QCOMPARE(faults_of(*index), std::string());
        }
    }
};

} // namespace scan_property_test

TP_TEST(scan_property_test, ScanPropertyTest, event_loop)
#include "scan_property_test.moc"
