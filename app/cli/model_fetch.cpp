// SPDX-License-Identifier: Apache-2.0
#include "app/cli/model_fetch.hpp"

#include "core/base/words.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_name.hpp"

#include <QCryptographicHash>
#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QSaveFile>
#include <QSslSocket>
#include <QTimer>

#include <memory>

namespace tp {

namespace {

constexpr int longest_silence_ms = 30'000;
constexpr int look_for_stop_every_ms = 100;
constexpr const char* other_ways = " Nothing has changed; try again when this machine is online, or get the "
                                   "file by other means and use --from FILE.";

std::string said(const QString& reason) {
    return (reason.endsWith('.') ? reason.chopped(1) : reason).toStdString() + ".";
}

/// One transfer into an open file.
class Transfer {
public:
    Transfer(QNetworkReply& reply, QSaveFile& file, const KnownFile& known, const FetchProgress& progress)
        : reply_(reply), file_(file), known_(known), progress_(progress) {}

    /// Why the file is not the known one, in a sentence; empty: it is.
    std::string run(const std::atomic<bool>& stop) {
        QEventLoop loop;
        QTimer look;
        QObject::connect(&reply_, &QNetworkReply::finished, &loop, &QEventLoop::quit);
        QObject::connect(&reply_, &QNetworkReply::readyRead, &loop, [this] { take(); });
        QObject::connect(&look, &QTimer::timeout, &loop, [this, &stop] {
            if (stop)
                end("It was stopped; nothing has changed.");
        });
        look.start(look_for_stop_every_ms);
        if (!reply_.isFinished())
            loop.exec();
        if (!problem_.empty())
            return problem_;
        // Whether a transfer that was cut off is an error to Qt depends on how it was cut.
        if (reply_.error() != QNetworkReply::NoError &&
            reply_.error() != QNetworkReply::RemoteHostClosedError)
            return "It cannot be fetched: " + said(reply_.errorString()) + other_ways;
        take();
        if (problem_.empty() && bytes_ != known_.bytes)
            return "What came has " + std::to_string(bytes_) + " bytes instead of " +
                   std::to_string(known_.bytes) +
                   ": it was cut off, or it is another file. Nothing has changed; try again.";
        if (problem_.empty() && hash_.result().toHex() != known_.sha256)
            return "What came is another file: its SHA-256 is " + hash_.result().toHex().toStdString() +
                   " instead of " + known_.sha256.toStdString() + ". Nothing has changed.";
        return problem_;
    }

private:
    void take() {
        const QByteArray bytes = reply_.readAll();
        bytes_ += bytes.size();
        hash_.addData(bytes);
        if (bytes_ > known_.bytes)
            end("What comes is larger than " + std::to_string(known_.bytes) +
                " bytes: it is another file. Nothing has changed.");
        else if (file_.write(bytes) != bytes.size())
            end("It cannot be written: " + said(file_.errorString()));
        else if (!bytes.isEmpty())
            progress_(bytes_);
    }

    void end(const std::string& problem) {
        if (problem_.empty())
            problem_ = problem;
        if (!reply_.isFinished())
            reply_.abort();
    }

    QNetworkReply& reply_;
    QSaveFile& file_;
    const KnownFile& known_;
    const FetchProgress& progress_;
    QCryptographicHash hash_{QCryptographicHash::Sha256};
    qint64 bytes_ = 0;
    std::string problem_;
};

} // namespace

Result<QByteArray> sha256_of(const QString& file) {
    QFile in(file);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!in.open(QIODevice::ReadOnly) || !hash.addData(&in))
        return Error{"The file " + tp::quoted(file.toStdString()) +
                     " cannot be read: " + said(in.errorString())};
    return hash.result().toHex();
}

Result<QString> fetch_file(const QUrl& address, const QString& target, const KnownFile& known,
                           const FetchProgress& progress, const std::atomic<bool>& stop) {
    const QString scheme = address.scheme();
    if (scheme != "http" && scheme != "https" && scheme != "file")
        return Error{"Only http, https and file addresses can be used, not " +
                     tp::quoted(address.toString().toStdString()) + "."};
    if (scheme == "https" && !QSslSocket::supportsSsl())
        return Error{"https needs Qt's TLS plugin and OpenSSL (Debian: libqt6network6, libssl3), which are "
                     "not installed: fetch the file by other means and use --from FILE."};
    const QString folder = QFileInfo(target).path();
    if (!QDir().mkpath(folder))
        return Error{"The folder " + tp::quoted(folder.toStdString()) + " cannot be created."};
    QSaveFile file(target); // removes its temporary file unless it is committed
    if (!file.open(QIODevice::WriteOnly))
        return Error{tp::quoted(target.toStdString()) + " cannot be written: " + said(file.errorString())};
    QNetworkAccessManager network;
    network.setTransferTimeout(longest_silence_ms);
    const std::unique_ptr<QNetworkReply> reply(network.get(QNetworkRequest(address)));
    if (const std::string problem = Transfer(*reply, file, known, progress).run(stop); !problem.empty())
        return Error{problem};
    if (!file.commit())
        return Error{tp::quoted(target.toStdString()) + " cannot be written: " + said(file.errorString())};
    sync_folder(path_named(folder.toStdString())); // where that fails, the file is there all the same
    return target;
}

} // namespace tp
