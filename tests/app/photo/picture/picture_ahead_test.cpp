// SPDX-License-Identifier: Apache-2.0
#include "app/photo/picture/overlay.hpp"
#include "app/photo/picture/picture_ahead.hpp"
#include "faces/decode/picture.hpp"

#include <QCoreApplication>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <opencv2/imgcodecs.hpp>

#include <fstream>
#include <map>
#include <mutex>
#include <string>

using namespace tp;
namespace fs = std::filesystem;

namespace {

constexpr QSize screen(40, 30);
constexpr std::size_t one_picture = 4 * 40 * 30;

/// Photographs that are read when the test lets them.
class Reader {
public:
    PictureAhead::Read read() {
        return [this](const fs::path& photo, QSize size) {
            QSemaphore* gate = nullptr;
            {
                const std::lock_guard lock(mutex_);
                begun_.push_back(photo.filename().string());
                gate = gates_.contains(begun_.back()) ? &gates_[begun_.back()] : nullptr;
            }
            if (gate)
                gate->acquire();
            ShownPicture picture;
            picture.image = QImage(size, QImage::Format_RGB32);
            return picture;
        };
    }
    /// From now on `photo` waits until it is let go.
    void hold(const std::string& photo) {
        const std::lock_guard lock(mutex_);
        gates_[photo];
    }
    void let_go(const std::string& photo) {
        const std::lock_guard lock(mutex_);
        gates_[photo].release();
    }
    /// In the order in which they were begun.
    std::vector<std::string> begun() {
        const std::lock_guard lock(mutex_);
        return begun_;
    }

private:
    std::mutex mutex_;
    std::vector<std::string> begun_;
    std::map<std::string, QSemaphore> gates_;
};

using Names = std::vector<std::string>;

} // namespace

class PictureAheadTest : public QObject {
    Q_OBJECT

    /// What was answered so far, by name.
    struct Answers {
        Names names;
        std::shared_ptr<const ShownPicture> last;
        explicit Answers(PictureAhead& ahead) {
            QObject::connect(&ahead, &PictureAhead::ready, [this](std::shared_ptr<const ShownPicture> picture) {
                names.push_back(picture->photo.filename().string());
                last = std::move(picture);
            });
        }
    };

    static void wait_until_idle(PictureAhead& ahead) {
        QSignalSpy idle(&ahead, &PictureAhead::idle);
        QVERIFY(idle.wait());
    }

private slots:
    void the_wanted_one_is_read_first_and_the_next_are_there_at_once() {
        Reader reader;
        PictureAhead ahead(screen, 10 * one_picture, reader.read());
        Answers answers(ahead);
        ahead.show("b", {"c", "a", "d"});
        wait_until_idle(ahead);
        QCOMPARE(answers.names, (Names{"b"}));
        QCOMPARE(reader.begun(), (Names{"b", "c", "a", "d"}));
        ahead.show("c", {"d", "b"});
        QCOMPARE(answers.names, (Names{"b", "c"})); // before anything else happened
        QCOMPARE(answers.last->image.size(), screen);
        QCOMPARE(reader.begun().size(), std::size_t{4});
    }

    void only_the_newest_wish_is_answered() {
        Reader reader;
        reader.hold("a");
        PictureAhead ahead(screen, 10 * one_picture, reader.read());
        Answers answers(ahead);
        ahead.show("a");
        QTRY_COMPARE(reader.begun(), (Names{"a"}));
        ahead.show("b", {"a"});
        QTRY_COMPARE(answers.names, (Names{"b"}));
        reader.let_go("a");
        wait_until_idle(ahead);
        QCOMPARE(answers.names, (Names{"b"}));
        ahead.show("a");
        QCOMPARE(answers.names, (Names{"b", "a"}));
        QCOMPARE(reader.begun(), (Names{"a", "b"}));
    }

    void one_that_is_read_ahead_does_not_keep_the_wanted_one_waiting() {
        Reader reader;
        reader.hold("slow");
        PictureAhead ahead(screen, 10 * one_picture, reader.read());
        Answers answers(ahead);
        ahead.show("a", {"slow", "c"});
        QTRY_COMPARE(reader.begun().size(), std::size_t{2});
        ahead.show("far");
        QTRY_COMPARE(answers.names, (Names{"a", "far"}));
        reader.let_go("slow");
        wait_until_idle(ahead);
        QCOMPARE(reader.begun(), (Names{"a", "slow", "far"}));
    }

    void one_that_is_being_read_ahead_is_not_read_twice() {
        Reader reader;
        reader.hold("b");
        PictureAhead ahead(screen, 10 * one_picture, reader.read());
        Answers answers(ahead);
        ahead.show("a", {"b"});
        QTRY_COMPARE(reader.begun().size(), std::size_t{2});
        ahead.show("b");
        reader.let_go("b");
        QTRY_COMPARE(answers.names, (Names{"a", "b"}));
        QCOMPARE(reader.begun(), (Names{"a", "b"}));
    }

    void no_more_is_held_than_there_is_room_for() {
        Reader reader;
        PictureAhead ahead(screen, 3 * one_picture, reader.read());
        Answers answers(ahead);
        ahead.show("a", {"b", "c", "d", "e", "f"});
        wait_until_idle(ahead);
        QCOMPARE(reader.begun(), (Names{"a", "b", "c", "d"}));
        QCOMPARE(ahead.held_bytes(), 3 * one_picture);
        ahead.show("b", {"c", "d", "e"});
        wait_until_idle(ahead);
        QCOMPARE(reader.begun(), (Names{"a", "b", "c", "d", "e"})); // "a" made room
        QVERIFY(ahead.held_bytes() <= 3 * one_picture);
        ahead.show("c", {"b", "d"}); // who goes back finds it as well
        QCOMPARE(answers.names, (Names{"a", "b", "c"}));
    }

    void without_room_the_wanted_one_is_shown_all_the_same() {
        Reader reader;
        PictureAhead ahead(screen, one_picture / 2, reader.read());
        Answers answers(ahead);
        ahead.show("a", {"b", "c"});
        wait_until_idle(ahead);
        QCOMPARE(answers.names, (Names{"a"}));
        QCOMPARE(reader.begun(), (Names{"a"}));
    }

    void real_photographs_are_read_for_the_screen_and_again_when_they_change() {
        const QTemporaryDir folder;
        const fs::path photo = fs::path(folder.path().toStdString()) / "photo.jpg";
        cv::Mat pixels(900, 1200, CV_8UC3);
        cv::randu(pixels, 0, 255);
        cv::imwrite(photo.string(), pixels);
        PictureAhead ahead(QSize(400, 400));
        Answers answers(ahead);
        ahead.show(photo);
        QTRY_COMPARE(answers.names.size(), std::size_t{1});
        QCOMPARE(answers.last->image, to_image(read_picture_to_fit(photo, {400, 400}).value()));
        QCOMPARE(answers.last->image.size(), QSize(400, 300));
        cv::imwrite(photo.string(), pixels(cv::Rect(0, 0, 900, 900)));
        ahead.show(photo);
        QTRY_COMPARE(answers.names.size(), std::size_t{2});
        QCOMPARE(answers.last->image.size(), QSize(400, 400));
        std::ofstream(photo) << "no photograph";
        ahead.show(photo);
        QTRY_COMPARE(answers.names.size(), std::size_t{3});
        QVERIFY(answers.last->image.isNull() && !answers.last->problem.empty());
    }

    void what_is_thrown_while_reading_is_a_sentence() {
        PictureAhead ahead(screen, one_picture, [](const fs::path&, QSize) -> ShownPicture { throw std::bad_alloc(); });
        Answers answers(ahead);
        ahead.show("a");
        QTRY_COMPARE(answers.names, (Names{"a"}));
        QVERIFY(answers.last->image.isNull() && answers.last->problem.ends_with("."));
    }

    void it_may_end_while_it_reads() {
        Reader reader;
        reader.hold("a");
        auto ahead = std::make_unique<PictureAhead>(screen, one_picture, reader.read());
        Answers answers(*ahead);
        ahead->show("a");
        QTRY_COMPARE(reader.begun().size(), std::size_t{1});
        reader.let_go("a");
        ahead.reset();
        QCoreApplication::processEvents();
        QVERIFY(answers.names.empty());
    }
};

QTEST_GUILESS_MAIN(PictureAheadTest)
#include "picture_ahead_test.moc"
