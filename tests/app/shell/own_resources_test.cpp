// SPDX-License-Identifier: Apache-2.0
// A page is asked for what a stranger's words might ask for: nothing of it leaves the machine or is read on it.
#include "app/shell/own_resources.hpp"

#include <QFile>
#include <QHostAddress>
#include <QImage>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QQmlComponent>
#include <QQmlEngine>
#include <QQuickItem>
#include <QQuickView>
#include <QString>
#include <QTcpServer>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>
#include <QtGlobal>

#include <memory>

using tp::keep_to_own_resources;

namespace {

/// What waits to be fetched: on a server of this machine, and in a folder of it.
struct Bait {
    QTcpServer server;
    QTemporaryDir folder;

    Bait() {
        server.listen(QHostAddress::LocalHost);
        QImage picture(8, 8, QImage::Format_RGB32);
        picture.fill(Qt::red);
        picture.save(folder.filePath("bait.png"));
    }
    QString remote() const { return QString("http://127.0.0.1:%1/bait.png").arg(server.serverPort()); }
    QString file() const { return QUrl::fromLocalFile(folder.filePath("bait.png")).toString(); }
    QString spelled_out() const {
        QFile picture(folder.filePath("bait.png"));
        picture.open(QFile::ReadOnly);
        return "data:image/png;base64," + picture.readAll().toBase64();
    }
};

/// A page of one item, of an engine that is kept where `kept` says so.
class OneItem {
public:
    OneItem(const QString& qml, bool kept) {
        if (kept)
            keep_to_own_resources(*view_.engine());
        QQmlComponent component(view_.engine());
        component.setData(("import QtQuick\nimport Qt.labs.folderlistmodel\n" + qml).toUtf8(), QUrl("qrc:/item.qml"));
        item_.reset(component.create());
        if (auto* shown = qobject_cast<QQuickItem*>(item_.get())) {
            shown->setParentItem(view_.contentItem());
            view_.show();
        }
    }
    QObject* operator->() const { return item_.get(); }
    bool made() const { return item_ != nullptr; }

private:
    QQuickView view_;
    std::unique_ptr<QObject> item_;
};

QString image(const QString& source) { return "Image { source: \"" + source + "\" }"; }
QString rich_text(const QString& source) {
    return "Text { textFormat: Text.RichText; text: '<img src=\"" + source + "\" width=\"8\"> name' }";
}

constexpr int ready = 1, failed = 3; ///< Image.Ready, Image.Error

/// Whether somebody called within a while in which one always did.
bool called(QTcpServer& server) { return QTest::qWaitFor([&] { return server.hasPendingConnections(); }, 300); }

} // namespace

class OwnResourcesTest : public QObject {
    Q_OBJECT
    Bait bait_;

private slots:
    void initTestCase() { QVERIFY(bait_.server.isListening()); }
    void init() {
        while (bait_.server.hasPendingConnections())
            delete bait_.server.nextPendingConnection();
    }

    void another_machine_hears_nothing() {
        for (const QString& qml : {image(bait_.remote()), rich_text(bait_.remote())}) {
            const OneItem item(qml, true);
            QVERIFY(item.made());
            QVERIFY2(!called(bait_.server), qPrintable(qml));
        }
    }

    /// Nor by the way that JavaScript, fonts and cursors take.
    void nobody_of_the_engine_s_asks_another_machine() {
        QQmlEngine engine;
        keep_to_own_resources(engine);
        const std::unique_ptr<QNetworkReply> reply(
            engine.networkAccessManager()->post(QNetworkRequest(QUrl(bait_.remote())), QByteArray("name")));
        QTRY_VERIFY(reply->isFinished());
        QVERIFY(reply->error() != QNetworkReply::NoError);
        QVERIFY(!called(bait_.server));
    }

    /// The bait is one.
    void without_it_another_machine_would() {
        for (const QString& qml : {image(bait_.remote()), rich_text(bait_.remote())}) {
            init();
            const OneItem item(qml, false);
            QVERIFY2(called(bait_.server), qPrintable(qml));
        }
    }

    void a_file_of_this_machine_is_no_picture_of_a_page() {
        const OneItem open(image(bait_.file()), false);
        QTRY_COMPARE(open->property("status").toInt(), ready);
        const OneItem kept(image(bait_.file()), true);
        QTRY_COMPARE(kept->property("status").toInt(), failed);
    }

    void pictures_that_are_spelled_out_are_shown() {
        const OneItem item(image(bait_.spelled_out()), true);
        QTRY_COMPARE(item->property("status").toInt(), ready);
    }

    /// The list of the file dialog that Qt draws itself.
    void folders_are_listed_for_those_who_choose_a_file() {
        const QString folder = QUrl::fromLocalFile(bait_.folder.path()).toString();
        const OneItem list("FolderListModel { folder: \"" + folder + "\"; nameFilters: [\"*.png\"] }", true);
        QTRY_COMPARE(list->property("count").toInt(), 1);
    }

    void code_of_another_s_is_not_run() {
        const QTemporaryDir folder;
        QFile file(folder.filePath("Stranger.qml"));
        QVERIFY(file.open(QFile::WriteOnly));
        file.write("import QtQuick\nItem { }\n");
        file.close();
        const QString loader = "Loader { source: \"" + QUrl::fromLocalFile(file.fileName()).toString() + "\" }";
        const OneItem open(loader, false);
        QTRY_COMPARE(open->property("status").toInt(), ready);
        const OneItem kept(loader, true);
        QTRY_COMPARE(kept->property("status").toInt(), failed);
    }
};

QTEST_MAIN(OwnResourcesTest)
#include "own_resources_test.moc"
