// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDir>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

#include <set>
#include <vector>

namespace tp::test {

/// A verb of touchphoto-lab that can take more than two seconds, and words with which it does.
struct LongVerb {
    QString name; ///< as the table in app/cli/VERBS.md names it
    QStringList words;
    QString leaves; ///< regular expression: files that it may leave, whole, when it is stopped
};

/// Something large for each of them, in a folder that goes with it. What cannot be written ends the program.
class LongWorkInputs {
public:
    LongWorkInputs();

    /// All long verbs, but for those that a program alone cannot bring to work (`devices tick`).
    const std::vector<LongVerb>& verbs() const { return verbs_; }
    /// Begins the verb; its stderr is the process's channel.
    void start(QProcess& process, const LongVerb& verb) const;

    QString path(const QString& name) const { return folder_.filePath(name); }
    /// Files that verbs have left there, by their names in the folder.
    std::set<QString> left() const;
    /// Away with them, and with folders.
    void remove_left() const;

private:
    /// A word behind @ is a file's name in the folder.
    void add(const char* name, const QString& words, const char* leaves = "");

    std::set<QString> names(QDir::Filters kind) const;

    QTemporaryDir folder_;
    std::set<QString> files_, folders_; ///< before any verb
    std::vector<LongVerb> verbs_;
};

/// The verbs, with what makes them long, that the table in app/cli/VERBS.md names.
std::set<QString> long_verbs_of_manual();

} // namespace tp::test
