// SPDX-License-Identifier: Apache-2.0
#include "app/shell/own_resources.hpp"

#include <QDir>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QObject>
#include <QQmlAbstractUrlInterceptor>
#include <QQmlNetworkAccessManagerFactory>
#include <QStringList>
#include <QUrl>

#include <algorithm>

namespace tp {

namespace {

const QUrl nowhere("qrc:/refused");

/// Fetches what is spelled out in the address itself.
class NoNetwork final : public QNetworkAccessManager {
public:
    using QNetworkAccessManager::QNetworkAccessManager;

protected:
    QNetworkReply* createRequest(Operation, const QNetworkRequest& asked, QIODevice*) override {
        const bool spelled_out = asked.url().scheme() == "data";
        return QNetworkAccessManager::createRequest(GetOperation, QNetworkRequest(spelled_out ? asked.url() : nowhere), nullptr);
    }
};

class NoNetworks final : public QQmlNetworkAccessManagerFactory {
public:
    QNetworkAccessManager* create(QObject* parent) override { return new NoNetwork(parent); }
};

/// An engine's own: it goes with it.
class OwnAddresses final : public QObject, public QQmlAbstractUrlInterceptor {
public:
    explicit OwnAddresses(QQmlEngine& engine) : QObject(&engine) {
        for (const QString& folder : engine.importPathList())
            if (!folder.startsWith(':') && !folder.startsWith("qrc:"))
                modules_ << QDir::cleanPath(folder) + '/';
    }

    QUrl intercept(const QUrl& address, DataType type) override { return own(address, type) ? address : nowhere; }

private:
    bool own(const QUrl& address, DataType type) const {
        if (QStringList{"", "qrc", "image", "data"}.contains(address.scheme()))
            return true;
        const QString file = QDir::cleanPath(address.toLocalFile()); // empty where it is none of this machine
        return type != UrlString &&
               std::any_of(modules_.begin(), modules_.end(), [&](const QString& folder) { return file.startsWith(folder); });
    }

    QStringList modules_; ///< folders with the QML of Qt
};

} // namespace

void keep_to_own_resources(QQmlEngine& engine) {
    static NoNetworks no_networks;
    engine.addUrlInterceptor(new OwnAddresses(engine));
    engine.setNetworkAccessManagerFactory(&no_networks);
}

} // namespace tp
