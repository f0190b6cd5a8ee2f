// SPDX-License-Identifier: Apache-2.0
#include "app/parts/preferences/preferences.hpp"

#include "audio/sentences/sentences.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_name.hpp"
#include "core/files/whole_file.hpp"

#include <QStandardPaths>

#include <system_error>

namespace tp {

namespace {
constexpr int keep_after_ms = 500;
constexpr std::size_t most_bytes = 1 << 20;
} // namespace

std::filesystem::path Preferences::usual_file() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation);
    return path_named(folder.toStdString()) / "preferences.json";
}

Preferences::Preferences(std::filesystem::path file, QObject* parent)
    : QObject(parent), file_(std::move(file)) {
    soon_.setSingleShot(true);
    soon_.setInterval(keep_after_ms);
    connect(&soon_, &QTimer::timeout, this, [this] {
        if (const QString why = keep(); !why.isEmpty())
            emit not_kept(why);
    });
    std::error_code error;
    if (file_.empty() || is_gone(file_))
        return;
    const Result<std::string> text = read_whole(file_, most_bytes);
    bool spoilt = !text.ok();
    if (text)
        choices_ = choices_from(QByteArray::fromStdString(*text), {}, &spoilt);
    kept_ = choices_;
    if (!spoilt)
        return;
    std::filesystem::path aside = file_;
    aside += ".aside";
    std::filesystem::rename(file_, aside, error);
    notice_ =
        error ? tr("Your settings could not be read. The default settings are used until that is put right.")
              : tr("Your settings could not be read and were set aside. The default settings are used; you "
                   "can choose again on the settings page.");
}

Preferences::~Preferences() { keep(); }

void Preferences::set(const Choices& choices) {
    if (choices == choices_)
        return;
    choices_ = choices;
    if (!soon_.isActive())
        soon_.start();
    emit changed();
}

QString Preferences::keep() {
    soon_.stop();
    if (file_.empty() || choices_ == kept_)
        return {};
    std::string why = make_folder(file_.parent_path(), Readers::owner_only);
    if (why.empty())
        why = replace_file(file_, json_of(choices_).toStdString(), Readers::owner_only);
    if (!why.empty())
        return tr("Your settings could not be saved: %1").arg(in_persons_language(why));
    kept_ = choices_;
    return {};
}

} // namespace tp
