// SPDX-License-Identifier: Apache-2.0
// A scanning process is killed again and again; the index stays whole and the next scan goes on. Called with
// --scan ALBUM CACHE this program is that process: it writes a byte for each photograph that it has read.
#include "test_album.hpp"

#include <QCoreApplication>
#include <QTest>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

using namespace tp;
using namespace tp::testing;

namespace {

int scan_and_tell(const char* album, const char* cache) {
    auto index = AlbumIndex::open(cache);
    if (!index || index->is_in_memory())
        return 1;
    ScanTools tools;
    tools.read_record = read_synthetic;
    tools.progress = [](const ScanProgress&) {
        if (::write(STDOUT_FILENO, ".", 1) != 1)
            std::abort();
    };
    const auto report = scan_album(*index, {album}, tools);
    return report && !report.value().stopped ? 0 : 1;
}

/// A process that scans, and the bytes that it writes.
class Scanner {
public:
    explicit Scanner(const TestAlbum& album) {
        int ends[2];
        if (::pipe(ends) != 0)
            qFatal("no pipe");
        const std::string program = fs::read_symlink("/proc/self/exe"), root = album.root(),
                          cache = album.cache();
        pid_ = ::fork();
        if (pid_ == 0) {
            ::dup2(ends[1], STDOUT_FILENO);
            ::close(ends[0]);
            ::close(ends[1]);
            ::execl(program.c_str(), program.c_str(), "--scan", root.c_str(), cache.c_str(), nullptr);
            ::_exit(127);
        }
        ::close(ends[1]);
        told_ = ends[0];
    }
    ~Scanner() { ::close(told_); }
    Scanner(const Scanner&) = delete;
    Scanner& operator=(const Scanner&) = delete;

    /// Reads that many bytes, or until it has ended.
    std::size_t read(std::size_t count) {
        std::size_t done = 0;
        for (char byte = 0; done < count && ::read(told_, &byte, 1) == 1;)
            ++done;
        return done;
    }
    void kill() { ::kill(pid_, SIGKILL); }
    /// Its exit status; -1: it was killed.
    int wait() {
        int status = 0;
        ::waitpid(pid_, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    pid_t pid_ = 0;
    int told_ = -1;
};

constexpr std::size_t everything = 1'000'000;

} // namespace

class KilledScanTest : public QObject {
    Q_OBJECT

private slots:
    void a_killed_scan_leaves_the_index_whole() {
        TestAlbum album;
        SyntheticAlbum(1).write(album.root(), 900);
        SyntheticAlbum moments(2);
        std::size_t photos = 0;
        for (int i = 0; i < 20; ++i) {
            Scanner scanner(album);
            scanner.read(moments.below(500)); // 0: while it opens the index
            scanner.kill();
            scanner.wait();
            auto index = AlbumIndex::open(album.cache());
            QVERIFY2(index->notices().empty(), index->notices().empty() ? "" : index->notices()[0].c_str());
            QCOMPARE(faults_of(*index), std::string());
            const std::size_t now = index->totals().value().photos;
            QVERIFY(now >= photos); // what was committed stays
            photos = now;
            if (photos == 900) { // begin again
                QCOMPARE(index->dump().value(), album.fresh_dump());
                index = AlbumIndex::in_memory();
                QCOMPARE(AlbumIndex::discard(album.cache()), std::string());
                photos = 0;
            }
        }
        auto index = AlbumIndex::open(album.cache());
        QVERIFY(album.scan(*index).ok());
        QCOMPARE(index->dump().value(), album.fresh_dump());
    }

    void two_processes_share_an_index() {
        TestAlbum album;
        SyntheticAlbum(1).write(album.root(), 600);
        for (int i = 0; i < 3; ++i) {
            Scanner one(album), two(album);
            one.read(100);
            for (int n = 0; n < 50; ++n)
                TestAlbum::set_people(album.root() / "Reise 3" / ("IMG_" + std::to_string(401 + n) + ".jpg"),
                                      {"Person " + std::to_string(i)});
            two.read(everything);
            one.read(everything);
            QCOMPARE(one.wait(), 0);
            QCOMPARE(two.wait(), 0);
            auto index = AlbumIndex::open(album.cache());
            QVERIFY(index->notices().empty());
            QVERIFY(album.scan(*index).ok());
            QCOMPARE(index->dump().value(), album.fresh_dump());
            QCOMPARE(faults_of(*index), std::string());
        }
    }
};

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (argc == 4 && std::string_view(argv[1]) == "--scan")
        return scan_and_tell(argv[2], argv[3]);
    KilledScanTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "killed_scan_test.moc"
