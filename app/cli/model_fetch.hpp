// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <QByteArray>
#include <QString>
#include <QUrl>

#include <atomic>
#include <functional>

namespace tp {

/// The SHA-256 of a file in hexadecimal digits; an error where it cannot be read.
Result<QByteArray> sha256_of(const QString& file);

/// What tells a file from all others.
struct KnownFile {
    qint64 bytes = 0;
    QByteArray sha256; ///< in hexadecimal digits
};

/// Called now and then with the number of bytes that have come.
using FetchProgress = std::function<void(qint64 bytes)>;

/// Brings the `known` file from an address (http, https or file; redirects are followed, never from https to
/// http) to `target`, by way of a temporary file beside it that takes its place once size and checksum are
/// right and everything is on the disk. On an error, or once `stop` is true, nothing is left behind and a
/// file at `target` is as it was. Runs an event loop: not for a thread that has one already.
Result<QString> fetch_file(const QUrl& address, const QString& target, const KnownFile& known,
                           const FetchProgress& progress, const std::atomic<bool>& stop);

} // namespace tp
