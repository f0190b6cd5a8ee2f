// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/dispatcher_worker.hpp"

#include "audio/speech/language_runs.hpp"

#include <QDeadlineTimer>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QThread>

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace tp {

namespace {

constexpr int start_ms = 5000; ///< that a speech-dispatcher may take to open its socket
constexpr int look_ms = 10;

constexpr int message_queued = 225;
constexpr int first_refusal = 300; ///< and all above that are no events
constexpr int event_begin = 701;
constexpr int event_end = 702;
constexpr int event_cancelled = 703;

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string() : value;
}

} // namespace

/// As speech-dispatcher's own library finds it.
std::string DispatcherWorker::usual_socket() {
    constexpr std::string_view by_socket = "unix_socket:";
    if (const std::string address = variable("SPEECHD_ADDRESS"); address.starts_with(by_socket))
        return address.substr(by_socket.size());
    std::string folder = variable("XDG_RUNTIME_DIR");
    if (folder.empty())
        folder = variable("XDG_CACHE_HOME");
    if (folder.empty())
        folder = variable("HOME") + "/.cache";
    return folder + "/speech-dispatcher/speechd.sock";
}

DispatcherWorker::DispatcherWorker(std::string socket, bool may_start) : path_(std::move(socket)), may_start_(may_start) {}

DispatcherWorker::~DispatcherWorker() { hang_up(); }

bool DispatcherWorker::connected() {
    socket_ = LocalSocket::to(path_);
    return socket_.ok();
}

/// Starts the server, and is connected to it.
bool DispatcherWorker::started() {
    QProcess starter;
    starter.setStandardOutputFile(QProcess::nullDevice());
    starter.setStandardErrorFile(QProcess::nullDevice());
    starter.start("speech-dispatcher",
                  {"--spawn", "--communication-method", "unix_socket", "--socket-path", QString::fromStdString(path_)});
    if (!starter.waitForFinished(start_ms))
        return false;
    // One that would not start may have found another on its way.
    const QDeadlineTimer patience(starter.exitCode() == 0 ? start_ms : start_ms / 5);
    while (!connected()) {
        if (patience.hasExpired())
            return false;
        QThread::msleep(look_ms);
    }
    return true;
}

bool DispatcherWorker::open() {
    if (!connected() && !(may_start_ && started()))
        return false;
    ear_ = std::make_unique<QSocketNotifier>(socket_.number(), QSocketNotifier::Read);
    connect(ear_.get(), &QSocketNotifier::activated, this, &DispatcherWorker::hear);
    std::string user = variable("USER");
    if (user.find_first_of(": \r\n") != std::string::npos || user.empty())
        user = "unknown";
    send({"SET SELF CLIENT_NAME " + user + ":touchphoto:main\r\n"});
    for (const char* event : {"BEGIN", "END", "CANCEL"})
        send({std::string("SET SELF NOTIFICATION ") + event + " ON\r\n"});
    return true;
}

void DispatcherWorker::say(quint64 id, const QString& text) {
    const std::vector<LanguageRun> runs =
        own_language_.isEmpty() ? std::vector<LanguageRun>{{text, {}}} : language_runs(text, own_language_, name_languages());
    said_ = id;
    left_ = runs.size();
    for (const LanguageRun& run : runs) {
        const bool foreign = run.language != own_language_;
        if (foreign)
            use_voice_of(run.language);
        send({"SPEAK\r\n", id});
        send({ssip_text(run.text.toStdString()), id});
        if (foreign)
            use_voice_of(own_language_);
    }
}

void DispatcherWorker::silence() { send({"CANCEL SELF\r\n"}); }

void DispatcherWorker::use_rate(double rate) {
    send({"SET SELF RATE " + std::to_string(std::lround(100.0 * rate)) + "\r\n"});
}

void DispatcherWorker::use_language(const QString& language) {
    own_language_ = language;
    use_voice_of(language);
}

void DispatcherWorker::use_voice_of(const QString& language) {
    send({"SET SELF LANGUAGE " + language.toStdString() + "\r\n"});
}

void DispatcherWorker::send(Command command) {
    commands_.push_back(std::move(command));
    if (commands_.size() == 1)
        send_next();
}

void DispatcherWorker::send_next() {
    if (commands_.empty())
        return;
    socket_.send(commands_.front().bytes); // where it has gone, hear() is told
}

void DispatcherWorker::hear() {
    std::array<char, 4096> bytes{};
    const std::optional<std::size_t> got = socket_.receive(bytes);
    if (!got)
        return;
    std::vector<SsipReply> replies;
    const bool sound = *got > 0 && reader_.read({bytes.data(), *got}, replies);
    for (const SsipReply& reply : replies)
        take(reply);
    if (!sound) {
        hang_up();
        emit failed();
    }
}

void DispatcherWorker::take(const SsipReply& reply) {
    if (reply.is_event())
        return take_event(reply);
    if (commands_.empty())
        return;
    const quint64 id = commands_.front().id;
    commands_.pop_front();
    if (reply.code == message_queued)
        messages_[reply.lines.front()] = id;
    const bool refused = reply.code >= first_refusal && id != 0;
    if (refused && !commands_.empty() && commands_.front().id == id)
        commands_.pop_front(); // the text that was to follow
    send_next();
    if (refused)
        not_begun(id);
}

void DispatcherWorker::take_event(const SsipReply& event) {
    const auto found = messages_.find(event.lines.front());
    if (found == messages_.end())
        return;
    const quint64 id = found->second;
    if (event.code == event_begin)
        begun(id);
    if (event.code != event_end && event.code != event_cancelled)
        return;
    messages_.erase(found);
    if (id == said_ && --left_ == 0)
        ended(id);
}

void DispatcherWorker::hang_up() {
    if (ear_ != nullptr)
        ear_->setEnabled(false); // it may be what calls
    socket_ = {};
}

} // namespace tp
