// SPDX-License-Identifier: Apache-2.0
#include "app/cli/model_fetch.hpp"
#include "small_web.hpp"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace tp;

namespace {

QByteArray some_model() {
    QByteArray bytes;
    for (int i = 0; i < 300'000; ++i)
        bytes.append(static_cast<char>((i * 31) ^ (i >> 8)));
    return bytes;
}

} // namespace

class ModelFetchTest : public QObject {
    Q_OBJECT
    const QByteArray model_ = some_model();
    const KnownFile known_{model_.size(),
                           QCryptographicHash::hash(model_, QCryptographicHash::Sha256).toHex()};
    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<SmallWeb> web_;

    QString path(const QString& name) const { return folder_->filePath(name); }
    QString put(const QString& name, const QByteArray& bytes) const {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("cannot write");
        return file.fileName();
    }
    QByteArray get(const QString& name) const {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
    }
    Result<QString> fetched(const QUrl& address, const QString& name = "models/net.onnx") const {
        const std::atomic<bool> stop{false};
        return fetch_file(
            address, path(name), known_, [](qint64) {}, stop);
    }
    QStringList left() const {
        return QDir(path("models")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }

private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        web_ = std::make_unique<SmallWeb>();
        QVERIFY(folder_->isValid() && web_->isListening());
    }

    void the_known_file_is_installed_data() {
        QTest::addColumn<QString>("from");
        QTest::newRow("web") << "/net.onnx";
        QTest::newRow("moved") << "/moved";
        QTest::newRow("file") << "";
    }
    void the_known_file_is_installed() {
        QFETCH(QString, from);
        web_->serve("/net.onnx", model_);
        web_->redirect("/moved", "/net.onnx");
        const auto done =
            fetched(from.isEmpty() ? QUrl::fromLocalFile(put("their.onnx", model_)) : web_->address(from));
        QVERIFY2(done.ok(), done.error().c_str());
        QCOMPARE(*done, path("models/net.onnx"));
        QCOMPARE(get("models/net.onnx"), model_);
        QCOMPARE(left(), QStringList{"net.onnx"});
        QVERIFY(QFile::permissions(path("models/net.onnx")) & QFile::ReadOwner);
        QCOMPARE(*sha256_of(path("models/net.onnx")), known_.sha256);
    }

    void progress_ends_with_all_of_it() {
        web_->serve("/net.onnx", model_);
        QList<qint64> steps;
        const std::atomic<bool> stop{false};
        QVERIFY(fetch_file(
                    web_->address("/net.onnx"), path("net.onnx"), known_,
                    [&](qint64 bytes) { steps.append(bytes); }, stop)
                    .ok());
        QVERIFY(std::is_sorted(steps.begin(), steps.end()));
        QCOMPARE(steps.last(), known_.bytes);
    }

    void what_is_not_the_known_file_changes_nothing_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("another file of that size") << QByteArray("/other") << QByteArray("another file");
        QTest::newRow("smaller") << QByteArray("/small") << QByteArray("has 100 bytes instead of 300000");
        QTest::newRow("larger") << QByteArray("/large") << QByteArray("larger than 300000 bytes");
        QTest::newRow("nothing") << QByteArray("/empty") << QByteArray("has 0 bytes");
        QTest::newRow("a page") << QByteArray("/page") << QByteArray("instead of 300000");
        QTest::newRow("cut off") << QByteArray("/cut") << QByteArray("it was cut off");
        QTest::newRow("not there") << QByteArray("/gone") << QByteArray("cannot be fetched");
        QTest::newRow("in a circle") << QByteArray("/circle") << QByteArray("cannot be fetched");
        QTest::newRow("out of the web") << QByteArray("/inwards") << QByteArray("cannot be fetched");
    }
    void what_is_not_the_known_file_changes_nothing() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, says);
        QByteArray other = model_;
        other[150'000] = static_cast<char>(other[150'000] ^ 1);
        web_->serve("/other", other);
        web_->serve("/small", model_.left(100));
        web_->serve("/large", model_ + model_);
        web_->serve("/empty", "");
        web_->serve("/page", "<html>Log in first</html>");
        web_->serve("/cut", model_.left(200'000), model_.size());
        web_->redirect("/circle", "/circle");
        web_->redirect("/inwards", QUrl::fromLocalFile(put("their.onnx", model_)).toEncoded());
        for (const bool installed : {false, true}) {
            if (installed)
                put("models/net.onnx", "what the user had");
            const auto done = fetched(web_->address(from));
            QVERIFY(!done.ok());
            QVERIFY2(done.error().find(says.toStdString()) != std::string::npos, done.error().c_str());
            QVERIFY2(done.error().ends_with('.'), done.error().c_str());
            QCOMPARE(left(), installed ? QStringList{"net.onnx"} : QStringList{});
        }
        QCOMPARE(get("models/net.onnx"), QByteArray("what the user had"));
    }

    void what_a_user_had_is_replaced_by_the_known_file() {
        QVERIFY(QDir().mkpath(path("models")));
        put("models/net.onnx", "what the user had");
        web_->serve("/net.onnx", model_);
        QVERIFY(fetched(web_->address("/net.onnx")).ok());
        QCOMPARE(get("models/net.onnx"), model_);
        QCOMPARE(left(), QStringList{"net.onnx"});
    }

    void stopped_while_nothing_comes_it_leaves_nothing() {
        web_->fall_silent_after("/slow", model_.left(1000), model_.size());
        std::atomic<bool> stop{false};
        const auto done = fetch_file(
            web_->address("/slow"), path("models/net.onnx"), known_, [&](qint64) { stop = true; }, stop);
        QVERIFY2(done.error().find("stopped") != std::string::npos, done.error().c_str());
        QCOMPARE(left(), QStringList{});
    }

    void places_and_addresses_that_cannot_be_are_sentences() {
        const QUrl good = QUrl::fromLocalFile(put("their.onnx", model_));
        put("file", "not a folder");
        for (const auto& [address, target] : {std::pair{good, QString("file/net.onnx")},
                                              {good, QString("file/deeper/net.onnx")},
                                              {QUrl("ftp://127.0.0.1/net.onnx"), QString("net.onnx")},
                                              {QUrl(), QString("net.onnx")},
                                              {QUrl::fromLocalFile(path("missing")), QString("net.onnx")},
                                              {QUrl::fromLocalFile(folder_->path()), QString("net.onnx")},
                                              {QUrl("http://127.0.0.1:1/net.onnx"), QString("net.onnx")}}) {
            const auto done = fetched(address, target);
            QVERIFY(!done.ok());
            QVERIFY2(done.error().ends_with('.') && done.error().size() > 20, done.error().c_str());
            QVERIFY(!QFile::exists(path("net.onnx")));
        }
        QCOMPARE(get("file"), QByteArray("not a folder"));
        QVERIFY(!sha256_of(path("missing")).ok());
    }
};

QTEST_GUILESS_MAIN(ModelFetchTest)
#include "model_fetch_test.moc"
