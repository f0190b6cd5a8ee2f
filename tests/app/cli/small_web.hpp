// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QHash>
#include <QHostAddress>
#include <QObject>
#include <QTcpServer>
#include <QTcpSocket>
#include <QUrl>

/// A web server on this machine that says what it was told to say and counts who asks.
class SmallWeb : public QTcpServer {
public:
    SmallWeb() {
        listen(QHostAddress::LocalHost);
        connect(this, &QTcpServer::newConnection, this, [this] {
            QTcpSocket* guest = nextPendingConnection();
            connect(guest, &QTcpSocket::disconnected, guest, &QObject::deleteLater);
            connect(guest, &QTcpSocket::readyRead, guest, [this, guest] { answer(*guest); });
        });
    }

    QUrl address(const QString& path) const {
        return QUrl(QStringLiteral("http://127.0.0.1:%1%2").arg(serverPort()).arg(path));
    }
    /// 200 with `body`, announced as `length` bytes.
    void serve(const QByteArray& path, const QByteArray& body, qsizetype length) {
        answers_[path] = "HTTP/1.1 200 OK\r\nContent-Length: " + QByteArray::number(length) +
                         "\r\nConnection: close\r\n\r\n" + body;
    }
    void serve(const QByteArray& path, const QByteArray& body) { serve(path, body, body.size()); }
    void redirect(const QByteArray& path, const QByteArray& to) {
        answers_[path] =
            "HTTP/1.1 302 Found\r\nLocation: " + to + "\r\nContent-Length: 0\r\nConnection: close\r\n\r\n";
    }
    /// Begins to answer and then says nothing more.
    void fall_silent_after(const QByteArray& path, const QByteArray& body, qsizetype length) {
        serve(path, body, length);
        silent_ = path;
    }
    int asked() const { return asked_; }

private:
    void answer(QTcpSocket& guest) {
        const QByteArray path = guest.readAll().split(' ').value(1);
        ++asked_;
        guest.write(answers_.value(path, "HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n"));
        guest.flush();
        if (path != silent_)
            guest.disconnectFromHost();
    }

    QHash<QByteArray, QByteArray> answers_;
    QByteArray silent_;
    int asked_ = 0;
};
