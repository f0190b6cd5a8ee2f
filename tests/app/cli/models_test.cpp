// SPDX-License-Identifier: Apache-2.0
// touchphoto-lab models as a shell sees it.
#include "faces/models/model_catalog.hpp"
#include "lab_process.hpp"
#include "places.hpp"
#include "small_web.hpp"

#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace tp;

namespace {

const QString another_net = QString(tp::test::in_source("resources/models/eye.onnx"));
const QString known_yunet = QString(tp::test::in_shared("faces/models/yunet.onnx"));

QByteArray bytes_of(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// As lab, while servers of this process go on answering.
Run lab_and_serve(const QStringList& words, const QByteArray& input) {
    QProcess process;
    QEventLoop loop;
    QObject::connect(&process, &QProcess::finished, &loop, &QEventLoop::quit);
    process.start(tp::test::in_build("bin/touchphoto-lab"), words);
    process.write(input);
    process.closeWriteChannel();
    loop.exec();
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace

class ModelsTest : public QObject {
    Q_OBJECT
    std::unique_ptr<QTemporaryDir> folder_;

    QString models() const { return folder_->filePath("touchphoto/models"); }
    QString yunet() const { return models() + "/yunet.onnx"; }
    void put(const QString& name, const QByteArray& bytes) const {
        QVERIFY(QDir().mkpath(QFileInfo(name).path()));
        QFile file(name);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    QStringList left() const {
        return QDir(models()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }

private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        qunsetenv("TOUCHPHOTO_MODELS");
        qputenv("XDG_DATA_HOME", folder_->path().toUtf8());
    }

    void list_says_what_there_is_and_where() {
        const Run none = lab({"models", "list"});
        QCOMPARE(none.code, 0);
        QCOMPARE(none.err, QByteArray());
        for (const EmbeddedModelFacts& model : embedded_models())
            QVERIFY(none.out.contains(QByteArray("  ") + model.name));
        for (const PluggableModel* model : pluggable_models)
            for (const char* fact : {model->name, model->file, model->description, model->licence})
                QVERIFY2(none.out.contains(fact), fact);
        QVERIFY(none.out.contains("345478 bytes") &&
                none.out.contains("inside the program; a file yunet.onnx"));
        QVERIFY(none.out.contains(lbf_model.origin) && none.out.contains(models().toUtf8()));
        put(yunet(), "any");
        QVERIFY(lab({"models", "list"}).out.contains("installed: " + yunet().toUtf8()));
    }

    void check_is_content_without_optional_models() {
        const Run run = lab({"models", "check"});
        QCOMPARE(run.code, 0);
        QVERIFY(run.out.startsWith("embedded: loads") && run.out.contains("yunet: inside the program") &&
                run.out.contains("lbf: not installed"));
        QCOMPARE(run.err, QByteArray());
    }

    void check_says_what_cannot_be_used_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("another net") << bytes_of(another_net);
        QTest::newRow("a letter") << QByteArray("Dear Anna");
        QTest::newRow("empty") << QByteArray();
    }
    void check_says_what_cannot_be_used() {
        QFETCH(QByteArray, content);
        put(yunet(), content);
        const Run run = lab({"models", "check"});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.out.contains("that we do not know (SHA-256 ") && run.out.contains("cannot be used"),
                 run.out.constData());
        QVERIFY(run.out.contains("embedded: loads") && is_one_sentence(run.err));
    }

    void check_knows_the_known_file_and_lets_others_be() {
        const QByteArray known = bytes_of(known_yunet);
        if (known.isEmpty())
            QSKIP("needs ../shared/faces: a YuNet");
        put(yunet(), known);
        const Run run = lab({"models", "check"});
        QCOMPARE(run.code, 0);
        QVERIFY2(run.out.contains("the known file, loads and gives"), run.out.constData());
        const qsizetype maker = known.indexOf("pytorch");
        QVERIFY(maker > 0);
        put(yunet(), QByteArray(known).replace(maker, 7, "PYTORCH"));
        const Run other = lab({"models", "check"});
        QCOMPARE(other.code, 0);
        QVERIFY2(other.out.contains("do not know") && other.out.contains("), loads and gives"),
                 other.out.constData());
    }

    void nothing_is_fetched_without_a_yes_data() {
        QTest::addColumn<QByteArray>("answer");
        QTest::newRow("n") << QByteArray("n\n");
        QTest::newRow("no") << QByteArray("no\n");
        QTest::newRow("another word") << QByteArray("yesterday\n");
        QTest::newRow("only Enter") << QByteArray("\n");
        QTest::newRow("silence") << QByteArray();
    }
    void nothing_is_fetched_without_a_yes() {
        QFETCH(QByteArray, answer);
        SmallWeb web;
        const QString address = web.address("/net.onnx").toString();
        const Run run = lab_and_serve({"models", "fetch", "yunet", "--from", address}, answer);
        QCOMPARE(run.code, 1);
        for (const QByteArray& fact : {address.toUtf8(), QByteArray("MIT"), QByteArray("345478 bytes"),
                                       yunet().toUtf8(), QByteArray("Fetch it? [y/N] Nothing was fetched.")})
            QVERIFY2(run.err.contains(fact), run.err.constData());
        QCOMPARE(web.asked(), 0);
        QVERIFY(!QDir(models()).exists());
    }

    void a_yes_fetches_and_the_checksum_decides() {
        SmallWeb web;
        put(yunet(), "what the user had");
        web.serve("/other.onnx", QByteArray(345'478, 'x'));
        const Run other = lab_and_serve(
            {"models", "fetch", "yunet", "--from", web.address("/other.onnx").toString()}, "y\n");
        QCOMPARE(other.code, 1);
        QVERIFY2(other.err.contains("in place of another file") && other.err.contains("is another file"),
                 other.err.constData());
        QCOMPARE(left(), QStringList{"yunet.onnx"});
        QCOMPARE(bytes_of(yunet()), QByteArray("what the user had"));

        const QByteArray known = bytes_of(known_yunet);
        if (known.isEmpty())
            QSKIP("needs ../shared/faces: a YuNet");
        web.serve("/net.onnx", known);
        const QStringList words{"models", "fetch", "yunet", "--from", web.address("/net.onnx").toString()};
        const Run run = lab_and_serve(words, "Yes\n");
        QVERIFY2(run.code == 0, run.err.constData());
        QVERIFY(run.err.contains("100 %"));
        QCOMPARE(bytes_of(yunet()), known);
        QCOMPARE(left(), QStringList{"yunet.onnx"});
        const int asked = web.asked();
        const Run again = lab_and_serve(words, "y\n");
        QCOMPARE(again.code, 0);
        QVERIFY(again.err.contains("already installed") && is_one_sentence(again.err));
        QCOMPARE(web.asked(), asked);
    }

    void what_goes_wrong_on_the_way_says_what_to_do_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QByteArrayList>("says");
        QTest::newRow("cut off") << "/cut"
                                 << QByteArrayList{"has 1000 bytes instead of 345478", "try again."};
        QTest::newRow("another file")
            << "/other" << QByteArrayList{"its SHA-256 is ", yunet_model.sha256, "Nothing has changed."};
        QTest::newRow("too long") << "/long" << QByteArrayList{"larger than 345478", "Nothing has changed."};
        QTest::newRow("gone") << "/gone" << QByteArrayList{"cannot be fetched: ", "use --from FILE."};
        QTest::newRow("nobody there") << "" << QByteArrayList{"cannot be fetched: ", "use --from FILE."};
    }
    /// As a shell sees it, with an address of this machine in place of the known one.
    void what_goes_wrong_on_the_way_says_what_to_do() {
        QFETCH(QString, path);
        QFETCH(QByteArrayList, says);
        SmallWeb web;
        web.serve("/cut", QByteArray(1000, 'x'), 345'478);
        web.serve("/other", QByteArray(345'478, 'x'));
        web.serve("/long", QByteArray(345'479, 'x'));
        put(yunet(), "what the user had");
        const QString address =
            path.isEmpty() ? QStringLiteral("http://127.0.0.1:1/net.onnx") : web.address(path).toString();
        const Run run = lab_and_serve({"models", "fetch", "yunet", "--yes", "--from", address}, "");
        QCOMPARE(run.code, 1);
        const QByteArray last = run.err.split('\n').value(run.err.count('\n') - 1);
        for (const QByteArray& words : says)
            QVERIFY2(last.contains(words), run.err.constData());
        QVERIFY2(last.endsWith('.'), run.err.constData());
        QCOMPARE(left(), QStringList{"yunet.onnx"});
        QCOMPARE(bytes_of(yunet()), QByteArray("what the user had"));
    }

    void files_are_taken_by_name() {
        const Run other = lab({"models", "fetch", "yunet", "--yes", "--from", another_net});
        QCOMPARE(other.code, 1);
        QVERIFY(other.err.contains("from     file:///"));
        QCOMPARE(left(), QStringList{});
        if (!QFile::exists(known_yunet))
            QSKIP("needs ../shared/faces: a YuNet");
        qputenv("TOUCHPHOTO_MODELS", folder_->filePath("mine").toUtf8());
        QCOMPARE(lab({"models", "fetch", "yunet", "--yes", "--from", known_yunet}).code, 0);
        QCOMPARE(bytes_of(folder_->filePath("mine/yunet.onnx")), bytes_of(known_yunet));
    }

    void what_cannot_be_fetched_is_a_sentence_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("no such name") << "magic" << QByteArray("There are: yunet, haar, mesh, lbf.");
        QTest::newRow("inside the program") << "mouth" << QByteArray("is inside the program");
        QTest::newRow("no address") << "mesh" << QByteArray(mesh_model.origin);
        QTest::newRow("no checksum") << "lbf" << QByteArray(lbf_model.origin);
    }
    void what_cannot_be_fetched_is_a_sentence() {
        QFETCH(QString, name);
        QFETCH(QByteArray, says);
        const Run run = lab({"models", "fetch", name, "--yes"});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains(says) && run.err.count('\n') == 1, run.err.constData());
    }

    void without_a_checksum_only_a_file_that_works_is_taken_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("a file of another kind") << another_net << QByteArray("is not an LBF facemark");
        QTest::newRow("no file") << folder_->filePath("none.yaml") << QByteArray("none.yaml");
        QTest::newRow("an address") << "http://localhost:1/lbfmodel.yaml" << QByteArray(lbf_model.origin);
    }
    void without_a_checksum_only_a_file_that_works_is_taken() {
        QFETCH(QString, from);
        QFETCH(QByteArray, says);
        const Run run = lab({"models", "fetch", "lbf", "--yes", "--from", from});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains(says) && run.err.count('\n') == 1, run.err.constData());
        QCOMPARE(run.out, QByteArray());
        QCOMPARE(left(), QStringList{});
    }

    void a_folder_that_cannot_be_written_is_a_sentence() {
        put(folder_->filePath("file"), "not a folder");
        qputenv("TOUCHPHOTO_MODELS", folder_->filePath("file").toUtf8());
        const Run run = lab({"models", "fetch", "yunet", "--yes", "--from", another_net});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("cannot be created."), run.err.constData());
        qunsetenv("TOUCHPHOTO_MODELS");
        qunsetenv("XDG_DATA_HOME");
        const QByteArray home = qgetenv("HOME");
        qunsetenv("HOME");
        const Run homeless = lab({"models", "fetch", "yunet", "--yes", "--from", another_net});
        qputenv("HOME", home);
        QCOMPARE(homeless.code, 1);
        QVERIFY(homeless.err.contains("set TOUCHPHOTO_MODELS"));
    }

    void wrong_usage_is_code_2() {
        for (const QStringList& words :
             {QStringList{"models"}, QStringList{"models", "eat"}, QStringList{"models", "fetch"},
              QStringList{"models", "list", "yunet"}, QStringList{"models", "fetch", "yunet", "mesh"}})
            QCOMPARE(lab(words).code, 2);
        QCOMPARE(lab({"models", "--help"}).code, 0);
    }
};

QTEST_GUILESS_MAIN(ModelsTest)
#include "models_test.moc"
