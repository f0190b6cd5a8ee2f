// SPDX-License-Identifier: Apache-2.0
#include "app/pages/print/print_session.hpp"

#include "app/photo/tactile/tactile_file.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_name.hpp"
#include "core/files/free_name.hpp"

#include <QStandardPaths>
#include <QStringList>

#include <string>
#include <utility>

namespace tp {

std::filesystem::path PrintSession::usual_folder() {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return path_named(documents.toStdString()) / "TouchPhoto";
}

PrintSession::PrintSession(Narrator& narrator, EarconPlayer& earcons, std::filesystem::path folder,
                           PrintedPhoto::Read read)
    : narrator_(narrator), earcons_(earcons), folder_(std::move(folder)), photo_(std::move(read)),
      sheet_(photo_, narrator) {
    connect(&photo_, &PrintedPhoto::taken, this, [this] {
        sheet_.make();
        enter();
    });
}

void PrintSession::open_photo(const std::filesystem::path& photo) {
    sheet_.clear();
    photo_.open(photo);
}

void PrintSession::enter() {
    if (photo_.file().empty())
        return narrator_.tell(tr("Print. Choose a photograph on the page \"Look after the album\"."),
                              Priority::touch);
    if (photo_.looking())
        return narrator_.tell(tr("Print %1. Looking for faces…").arg(photo_.name()), Priority::touch);
    narrator_.tell(sheet_.ready() ? tr("Print %1 on %2.").arg(photo_.name(), sheet_.size()) + ' ' +
                                        sheet_.notes().join(' ')
                                  : sheet_.notes().join(' '),
                   Priority::touch);
}

void PrintSession::leave() { narrator_.stop(); }

void PrintSession::store(const QString& ending) {
    const auto refuse = [this](const QString& sentence) {
        earcons_.play(Earcon::error);
        narrator_.tell(sentence, Priority::message);
    };
    if (!sheet_.ready() || (ending != "pdf" && ending != "svg"))
        return refuse(sheet_.notes().isEmpty() ? tr("There is no sheet yet.") : sheet_.notes().join(' '));
    if (const std::string why = make_folder(folder_); !why.empty())
        return refuse(tr("The folder %1 could not be created: %2")
                          .arg(QString::fromStdString(name_in_utf8(folder_)), in_persons_language(why)));
    const QString stem = QString::fromStdString(name_in_utf8(folder_ / photo_.file().stem()));
    const auto file = free_name([&](int number) {
        const QString end = number == 1 ? QString() : ' ' + QString::number(number);
        return std::vector{path_named((stem + end + '.' + ending).toStdString())};
    });
    if (!file)
        return refuse(tr("The sheet cannot be saved: %1").arg(in_persons_language(file.error())));
    const auto written = write_tactile(*file, *sheet_.sheet());
    if (!written)
        return refuse(in_persons_language(written.error()));
    earcons_.play(Earcon::saved);
    narrator_.tell(tr("The sheet is saved as %1. Print it at 100 percent, unscaled.")
                       .arg(QString::fromStdString(name_in_utf8(*file))),
                   Priority::message);
}

} // namespace tp
