// SPDX-License-Identifier: Apache-2.0
#include "long_inputs.hpp"

#include "core/study_folder/path_file.hpp"
#include "core/study_folder/study_terms.hpp"
#include "drawn_study.hpp"
#include "places.hpp"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <tuple>
#include <unistd.h>
#include <vector>

namespace tp::test {

namespace {

void write(const QString& name, const QByteArray& bytes) {
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(name));
}

void make(const QString& folder) {
    if (!QDir().mkpath(folder))
        qFatal("cannot make %s", qPrintable(folder));
}

/// The same bytes once more, which take no place on the disk.
void link(const QString& file, const QString& name) {
    if (::link(qPrintable(file), qPrintable(name)) != 0)
        qFatal("cannot write %s", qPrintable(name));
}

void run(const QStringList& words) {
    QProcess process;
    process.setStandardOutputFile(QProcess::nullDevice());
    process.start(tp::test::in_build("bin/touchphoto-lab"), words);
    if (!process.waitForFinished(-1) || process.exitCode() != 0)
        qFatal("cannot run touchphoto-lab %s", qPrintable(words.join(' ')));
}

/// Long lines through each other, which no index likes.
QByteArray tangle() {
    std::mt19937 random(1);
    const auto place = [&random](unsigned below) {
        return QByteArray::number(0.1 * static_cast<double>(random() % (10 * below)));
    };
    QByteArray path = "M 0 0";
    for (int i = 0; i < 1'000'000; ++i)
        path += " L " + place(260) + ' ' + place(160);
    return "<svg xmlns='http://www.w3.org/2000/svg' width='260mm' height='160mm' viewBox='0 0 260 160'><path "
           "id='tangle' d='" +
           path + "'/></svg>";
}

/// Noise of many megapixels, in which a face is looked for long.
void write_large_photograph(const QString& file) {
    QImage picture(14'000, 12'500, QImage::Format_Grayscale8);
    std::mt19937 random(7);
    QByteArray row(picture.width(), '\0');
    for (int y = 0; y < picture.height(); ++y) {
        if (y % 10 == 0)
            for (qsizetype x = 0; x < row.size(); ++x)
                row[x] = x % 10 == 0 ? static_cast<char>(random()) : row[x - 1];
        std::copy(row.begin(), row.end(), picture.scanLine(y));
    }
    if (!picture.save(file, "jpg", 80))
        qFatal("cannot write %s", qPrintable(file));
}

/// Silence, which takes no place on the disk.
void write_sound(const QString& file, quint32 bytes) {
    const auto number = [](quint32 value) {
        return QByteArray(reinterpret_cast<const char*>(&value), 4); // of a machine that WAV was made for
    };
    write(file, "RIFF" + number(36 + bytes) + "WAVEfmt " + number(16) + QByteArray("\1\0\1\0", 4) +
                    number(48'000) + number(96'000) + QByteArray("\2\0\20\0", 4) + "data" + number(bytes));
    if (!QFile(file).resize(44 + qint64{bytes}))
        qFatal("cannot write %s", qPrintable(file));
}

/// Portraits of one person, and where their contours are, roughly.
void write_portraits(const QString& folder, const QString& portrait) {
    const auto oval = [](double x, double y, double width, double height) {
        QByteArray points;
        for (int i = 0; i < 16; ++i) {
            const double at = i * 0.392699;
            points += (i == 0 ? "[" : ", [") + QByteArray::number(x + width * std::cos(at), 'f', 1) + ", " +
                      QByteArray::number(y + height * std::sin(at), 'f', 1) + ']';
        }
        return '[' + points + ']';
    };
    const QByteArray contours = "{\"eye_on_the_left_of_the_picture\": " + oval(368, 472, 37, 12) +
                                ", \"eye_on_the_right_of_the_picture\": " + oval(531, 478, 37, 12) +
                                ", \"outer_lip\": " + oval(444, 662, 81, 33) +
                                ", \"inner_lip\": " + oval(444, 658, 60, 12) +
                                ", \"outline\": " + oval(450, 520, 210, 290) + '}';
    make(folder + "/portraits");
    QByteArray truth;
    for (int i = 0; i < 1'000; ++i) {
        const QString name = QStringLiteral("anna_%1.jpg").arg(i);
        link(portrait, folder + "/portraits/" + name);
        truth += (i == 0 ? "{\"" : ",\n\"") + name.toUtf8() + "\": " + contours;
    }
    write(folder + "/truth.json", truth + "}\n");
}

/// A photograph with a recording of its own; the recording's file.
QString write_spoken(const QString& folder, const QString& one, const QString& sound) {
    make(folder);
    const QString photo = folder + "/one.jpg";
    if (!QFile::copy(one, photo))
        qFatal("cannot write %s", qPrintable(photo));
    run({"album", "tag", "add", photo, "--from", sound});
    const QDir recordings(photo + ".tags");
    return recordings.filePath(recordings.entryList(QDir::Files).value(0));
}

/// Recordings that were added as short ones: one of hours to be read, one of gigabytes to be copied.
void write_long_recordings(const QString& folder) {
    const QString one = folder + "/one.jpg", sound = folder + "/short.wav";
    write_sound(sound, 96'000);
    const QString recording = write_spoken(folder + "/spoken", one, sound);
    if (!QFile::remove(recording))
        qFatal("nothing was added to a photograph");
    link(folder + "/long.wav", recording);
    if (!QFile(write_spoken(folder + "/labelled", one, sound)).resize(qint64{16} << 30))
        qFatal("cannot write a large recording");
}

/// A trash whose lists take long to read.
void write_trash(const QString& folder) {
    QByteArray list = "{\"what\": \"a photograph\", \"deleted\": \"2026-05-01T10:15:00Z\", \"files\": "
                      "[\"1.jpg\"], \"note\": \"\", "
                      "\"more\": [0";
    for (int i = 0; i < 4'000'000; ++i)
        list += ",0";
    write(folder + "/list.json", list + "]}");
    for (int i = 0; i < 1'000; ++i) {
        const QString entry = folder + QStringLiteral("/thrown_away/.touchphoto/trash/%1").arg(i);
        make(entry);
        link(folder + "/list.json", entry + "/list.json");
    }
}

/// A study with as many conditions as there may be, and paths of hours.
void write_study(const QString& folder) {
    const std::filesystem::path study = (folder + "/study").toStdString();
    std::string protocol =
        "experiment: large\ntitle: Many levels\ntask: follow\nset path: circle\nset law: exact\n"
        "order: random\nrepetitions: 1\nsurface: 200 x 200 mm\n";
    for (const auto& [name, first, step, unit] :
         {std::tuple("stiffness", 100, 10, "N/mm"), std::tuple("range", 1'000, 200, "mm")}) {
        std::string levels;
        for (int level = 0; level < 100; ++level)
            levels +=
                (level == 0 ? "" : ", ") + QString::number(0.001 * (first + step * level)).toStdString();
        protocol += "factor " + std::string(name) + ": " + levels + ' ' + unit + '\n';
    }
    std::mt19937 random(5);
    testing::draw_study(study, protocol, 30, [&random](int, const PlannedTrial&, TrialRecord& record) {
        record.error_mm = 1.0 + 0.001 * static_cast<double>(random() % 1'000);
        record.time_s = 10.0 + 0.01 * static_cast<double>(random() % 1'000);
    });
    testing::write_file(study / "study.txt", terms_text({5, true}));
    std::vector<FingerSample> path(300'000);
    for (std::size_t i = 0; i < path.size(); ++i)
        path[i] = {0.001 * static_cast<double>(i), 0.01 * static_cast<double>(i % 7'919), 1.0, 0.1, 0.2};
    std::filesystem::create_directories(study / "paths");
    testing::write_file(folder.toStdString() + "/path.csv.gz", path_bytes(path));
    for (int trial = 1; trial <= 1'000; ++trial)
        link(folder + "/path.csv.gz",
             QString::fromStdString((study / "paths" / path_file_name(1, trial)).string()));
}

} // namespace

void write_long_inputs(const QString& folder) {
    write(folder + "/tangle.svg", tangle());
    write_large_photograph(folder + "/large.jpg");
    write_sound(folder + "/long.wav", 2'000'000'000);
    if (!QFile::copy(in_source("resources/samples/anna_smiling.jpg"), folder + "/one.jpg"))
        qFatal("cannot write one.jpg");
    for (const char* name : {"/album", "/empty", "/heavy"})
        make(folder + name);
    for (int i = 0; i < 200; ++i)
        link(folder + "/large.jpg", folder + QStringLiteral("/heavy/%1.jpg").arg(i));
    for (int i = 0; i < 40'000; ++i)
        link(folder + "/one.jpg", folder + QStringLiteral("/album/%1.jpg").arg(i));
    run({"devices", "record", folder + "/short.rec", "--seconds", "0.1"});
    write_portraits(folder, folder + "/one.jpg");
    write_long_recordings(folder);
    write_trash(folder);
    write_study(folder);
}

} // namespace tp::test
