// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/speech/local_socket.hpp"
#include "audio/speech/speech_worker.hpp"
#include "audio/speech/ssip.hpp"

#include <QSocketNotifier>

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <string>

namespace tp {

/// speech-dispatcher, by its own protocol: it speaks within a tenth of a second. Qt's plugin for it first asks for every
/// voice of every language, which takes seconds, and its own library waits in every call for an answer: one that hangs could
/// not be left behind. One that does not run is started, as that library would. Names in other scripts, and those whose
/// language is known, are spoken by a voice of it (language_runs.hpp).
class DispatcherWorker final : public SpeechWorker {
    Q_OBJECT
public:
    explicit DispatcherWorker(std::string socket = usual_socket(), bool may_start = true);
    ~DispatcherWorker() override;

    static std::string usual_socket();

private:
    struct Command {
        std::string bytes;
        quint64 id = 0; ///< of the text that it belongs to; 0: none
    };

    bool open() override;
    void say(quint64 id, const QString& text) override;
    void silence() override;
    void use_rate(double rate) override;
    void use_language(const QString& language) override;

    void use_voice_of(const QString& language);
    bool connected();
    bool started();
    void send(Command command);
    void send_next();
    void hear();
    void take(const SsipReply& reply);
    void take_event(const SsipReply& event);
    void hang_up();

    std::string path_;
    bool may_start_;
    LocalSocket socket_;
    std::unique_ptr<QSocketNotifier> ear_;
    SsipReader reader_;
    std::deque<Command> commands_; ///< the first one is being answered
    std::map<std::string, quint64> messages_; ///< its numbers of texts that it has not ended yet, and ours
    QString own_language_;
    quint64 said_ = 0;     ///< the text given last, and
    std::size_t left_ = 0; ///< its parts that have not ended
};

} // namespace tp
