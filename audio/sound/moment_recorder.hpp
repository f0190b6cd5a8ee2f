// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/moment_worker.hpp"

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QThread>

#include <filesystem>

namespace tp {

/// The sound of a moment: of the 5 s before a shutter and the 5 s after it, on a thread of its own; lives on the page's thread
/// and never blocks it. While it listens nothing is written; what no shutter asked for is forgotten.
///
///     const quint64 number = moment.shutter();      // at once
///     moment.keep(number, tags_folder(photo), now); // when the photograph is on the disk
///     // kept(number, recording): list it among the photograph's recordings
class MomentRecorder final : public QObject {
    Q_OBJECT
public:
    /// `make_input` is called on the moment's thread; `system_microphone` for people, another for tests.
    explicit MomentRecorder(MakeInput make_input, QObject* parent = nullptr);
    /// What is being kept and not over stays as a part, which repair_folder() finds.
    ~MomentRecorder() override;

    /// The microphone is on, or off. Off, what is being kept ends.
    void listen();
    void rest();
    /// Sound comes in: to be told while it does.
    bool hears() const { return hears_; }

    /// The shutter acts; the number of its moment, for `keep` or `drop`.
    quint64 shutter();
    /// Keeps it in the folder of a photograph's recordings. `shutter`: when it acted.
    void keep(quint64 number, const std::filesystem::path& folder, const QDateTime& shutter);
    /// Nothing of it is wanted; no use any more once it is being kept.
    void drop(quint64 number);

signals:
    void hears_changed();
    void kept(quint64 number, const tp::FinishedRecording& recording);
    void failed(quint64 number, const QString& sentence);

private:
    template <typename Call>
    void ask(Call call);

    QThread* thread_;
    MomentWorker* worker_; ///< lives on thread_, whose end deletes it
    bool hears_ = false;
    quint64 last_ = 0;
};

} // namespace tp
