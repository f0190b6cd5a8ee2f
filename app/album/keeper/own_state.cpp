// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/own_state.hpp"

#include "core/files/file_name.hpp"

#include <QCryptographicHash>
#include <QStandardPaths>
#include <QString>

#include <cstdlib>
#include <string>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

fs::path own_state_folder() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing in the program changes its environment while threads run
    if (const char* const state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state == '/')
        return fs::path(state) / "touchphoto";
    const QString home = QStandardPaths::writableLocation(QStandardPaths::HomeLocation);
    return path_named(home.toStdString()) / ".local" / "state" / "touchphoto";
}

fs::path own_state_of(const fs::path& album) {
    std::error_code error;
    fs::path real = fs::weakly_canonical(album, error);
    if (error)
        real = fs::absolute(album, error).lexically_normal();
    if (!real.has_filename())
        real = real.parent_path();
    const std::string name = real.string();
    const QByteArray hash = QCryptographicHash::hash({name.data(), static_cast<qsizetype>(name.size())},
                                                     QCryptographicHash::Sha256);
    return own_state_folder() / "albums" / hash.toHex().left(32).toStdString();
}

} // namespace tp
