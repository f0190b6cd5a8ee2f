// SPDX-License-Identifier: Apache-2.0
// A disk that is full for a while: what cannot be kept is said, and kept when the same is tried again.
#include "album_folder.hpp"
#include "core/study_folder/path_file.hpp"
#include "worked_study.hpp"

#include <QTest>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fcntl.h>
#include <string>
#include <sys/syscall.h>
#include <unistd.h>

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

std::size_t room_in_tables = SIZE_MAX; ///< bytes that may still be put at the end of a file
std::size_t room_elsewhere = SIZE_MAX; ///< bytes that files which are written whole may still take
int cut_error = 0;                     ///< errno where a file is cut

} // namespace

extern "C" ssize_t write(int file, const void* bytes, size_t count) {
    const int flags = ::fcntl(file, F_GETFL);
    std::size_t& room = (flags & O_APPEND) != 0 ? room_in_tables : room_elsewhere;
    if (file > 2 && room != SIZE_MAX) {
        count = std::min(count, room);
        room -= count;
        if (count == 0) {
            errno = ENOSPC;
            return -1;
        }
    }
    return ::syscall(SYS_write, file, bytes, count);
}

extern "C" int ftruncate64(int file, off64_t size) noexcept {
    if (cut_error != 0) {
        errno = cut_error;
        return -1;
    }
    return static_cast<int>(::syscall(SYS_ftruncate, file, size));
}
extern "C" int ftruncate(int file, off_t size) noexcept { return ftruncate64(file, size); }

class FullDiskTest : public QObject {
    Q_OBJECT
    AlbumFolder place_;
    int count_ = 0;
    fs::path folder_;
    std::unique_ptr<StudyWriter> writer_;

    std::string does() {
        const TrialRecord record = worked_record(writer_->next(1).value(), 1);
        return writer_->keep(record, worked_path(record));
    }
    std::string table() const { return *read_whole(folder_ / "participant-001.csv", 10'000); }
    /// All that has been kept is there, and nothing else.
    void is_whole() {
        const auto study = read_study(folder_);
        QVERIFY2(study.ok(), study.error().c_str());
        QVERIFY(study->remarks.empty());
        QCOMPARE(study->records, writer_->records_of(1));
    }

private slots:
    void init() {
        folder_ = place_ / ("study-" + std::to_string(++count_));
        writer_ = StudyWriter::open(folder_, worked_experiment(), worked_terms, worked_mouse).value();
        QCOMPARE(does(), std::string());
    }
    void cleanup() {
        room_in_tables = room_elsewhere = SIZE_MAX;
        cut_error = 0;
        writer_.reset();
    }

    void a_line_that_has_no_room_is_kept_when_there_is_some() {
        const std::string before = table();
        for (const std::size_t room : {0U, 1U, 20U}) {
            room_in_tables = room;
            QVERIFY(does().ends_with("participant-001.csv\": the disk is full."));
            QCOMPARE(table(), before);
            is_whole();
        }
        room_in_tables = SIZE_MAX;
        QCOMPARE(does(), std::string());
        QCOMPARE(writer_->records_of(1).size(), std::size_t{2});
        is_whole();
    }
    /// A disk that does not even let half a line be taken away.
    void half_a_line_is_taken_away_before_the_next_one() {
        const std::string before = table();
        room_in_tables = 20;
        cut_error = EIO;
        QVERIFY(does().ends_with("participant-001.csv\": the disk is full."));
        QCOMPARE(table().size(), before.size() + 20);
        room_in_tables = SIZE_MAX;
        QVERIFY(does().ends_with("participant-001.csv\": the disk reports a fault."));
        QCOMPARE(table().size(), before.size() + 20);
        cut_error = 0;
        QCOMPARE(does(), std::string());
        is_whole();
        QCOMPARE(does(), std::string());
        is_whole();
    }
    void a_path_that_has_no_room_brings_no_line() {
        room_elsewhere = 50;
        const std::string said = does();
        QVERIFY(said.find("trial-0002.csv.gz") != std::string::npos && said.ends_with("the disk is full."));
        is_whole();
        QVERIFY(!name_taken(folder_ / "paths" / path_file_name(1, 2)));
        room_elsewhere = SIZE_MAX;
        QCOMPARE(does(), std::string());
        is_whole();
    }
    void a_machine_that_cannot_be_noted_brings_no_line() {
        writer_->use(worked_pad);
        const TrialRecord record = worked_record(writer_->next(1).value(), 1);
        room_elsewhere = path_bytes(worked_path(record)).size() + 10;
        QVERIFY(does().ends_with("sittings.csv\": the disk is full."));
        is_whole();
        room_elsewhere = SIZE_MAX;
        QCOMPARE(does(), std::string());
        QCOMPARE(read_study(folder_)->sittings,
                 (std::vector<StudySitting>{{1, 1, worked_mouse}, {1, 2, worked_pad}}));
    }
    void a_study_that_cannot_begin_says_so_and_begins_later() {
        for (const std::size_t room : {0U, 10U, 100U, 300U}) {
            const fs::path other = folder_ / ("in-" + std::to_string(room));
            room_elsewhere = room;
            const auto writer = StudyWriter::open(other, worked_experiment(), worked_terms, worked_mouse);
            QVERIFY(writer.error().starts_with("The study cannot write ") &&
                    writer.error().ends_with(": the disk is full."));
            room_elsewhere = SIZE_MAX;
            QVERIFY(StudyWriter::open(other, worked_experiment(), worked_terms, worked_mouse).ok());
        }
    }
};

QTEST_GUILESS_MAIN(FullDiskTest)
#include "full_disk_test.moc"
