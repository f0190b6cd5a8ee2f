// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/speech/spoken_names.hpp"

#include <QObject>
#include <QString>
#include <QTimer>

namespace tp {

/// One speech engine; every call on the thread that the worker was moved to. A text is over when the engine says so, or
/// after longer than any text takes: an engine that never says that it has ended must not silence the rest.
class SpeechWorker : public QObject {
    Q_OBJECT
public:
    SpeechWorker();

    void find_engine();
    void speak(quint64 id, const QString& text);
    void cancel();
    void set_rate(double rate);
    /// Empty: as the engine is.
    void set_language(const QString& language);
    /// For an engine that reads a part of a text in another voice; others leave them alone.
    void set_name_languages(const SpokenNames& names) { names_ = names; }

signals:
    void found();
    /// There is no such engine, or it has gone, or it is mute: without a sound card one calls itself ready until it must
    /// speak.
    void failed();
    /// It has begun to speak a text: it is no engine that only pretends.
    void spoke();
    void finished(quint64 id);

protected:
    /// False: there is none. May take seconds; the others are called after it, and only where it was true.
    virtual bool open() = 0;
    virtual void say(quint64 id, const QString& text) = 0;
    virtual void silence() = 0;
    virtual void use_rate(double rate) = 0;
    /// Of an engine without a voice of the language the one that it has.
    virtual void use_language(const QString& language) = 0;

    const SpokenNames& name_languages() const { return names_; }

    /// What the engine tells of a text; of any but the one that was given last it is ignored.
    void begun(quint64 id);
    void ended(quint64 id);
    void not_begun(quint64 id);

private:
    QTimer too_long_;
    bool open_ = false;
    double rate_ = 0.0;
    QString language_;
    SpokenNames names_;
    quint64 id_ = 0;     ///< what is being spoken; 0: nothing
    bool begun_ = false; ///< the engine has said that it speaks `id_`
    int failures_ = 0;   ///< texts in a row that were never begun
};

} // namespace tp
