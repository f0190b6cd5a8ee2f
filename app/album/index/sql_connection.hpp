// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QVariant>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <shared_mutex>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace tp {

/// Why SQLite would not; thrown inside this room only.
struct SqlFault {
    int code = 0; ///< SQLite's primary result code
    std::string text;

    bool damaged() const; ///< the file is no database, or a spoilt one
    bool full() const;
};

class SqlConnection;
class SqlTransaction;

/// Lets one thread at a time write to a database in memory, and no other read meanwhile: what SQLite does for
/// files by itself. A thread may come in several times.
using MemoryTurn = std::shared_ptr<std::shared_mutex>;

/// The result of one query. At most one of the same query at a time; ended, it holds no lock.
class SqlRun {
public:
    SqlRun(QSqlQuery& query, SqlConnection& connection);
    SqlRun(SqlRun&& other) noexcept
        : query_(std::exchange(other.query_, nullptr)), connection_(other.connection_) {}
    SqlRun& operator=(SqlRun&&) = delete;
    ~SqlRun();

    bool next(); ///< goes to the first or next row; throws SqlFault
    std::int64_t integer(int column) const;
    double real(int column) const;
    std::string text(int column) const; ///< UTF-8
    std::string bytes(int column) const;
    bool null(int column) const;

private:
    QSqlQuery* query_;
    SqlConnection* connection_;
};

/// Bytes that need not be text, such as a file's name.
struct SqlBytes {
    std::string_view bytes;
};

/// One connection to an SQLite database. It belongs to the thread that made it.
class SqlConnection {
public:
    /// Throws SqlFault. The file is made where it is missing, for its owner only.
    static SqlConnection to_file(const std::filesystem::path& file);
    /// A database in this process's memory, gone with the last connection to it.
    static SqlConnection to_memory(const std::string& name, const MemoryTurn& turn);
    SqlConnection(SqlConnection&& other) noexcept;
    SqlConnection& operator=(SqlConnection&&) = delete;
    ~SqlConnection();

    /// Runs `sql`, prepared once; it must live as long as the connection. Throws SqlFault.
    template <typename... Values>
    SqlRun run(const char* sql, const Values&... values) {
        QSqlQuery& query = prepared(sql);
        int place = 0;
        (query.bindValue(place++, variant(values)), ...);
        return execute(query);
    }
    /// For what is run once, such as a schema.
    void run_once(const std::string& sql);
    std::int64_t last_id() const { return last_id_; } ///< of the row inserted last by `run`

private:
    friend SqlRun;
    friend SqlTransaction;
    SqlConnection(const QString& path, const QString& options, MemoryTurn turn);
    void begin_run();
    void end_run();
    QSqlQuery& prepared(const char* sql);
    SqlRun execute(QSqlQuery& query);

    static QVariant variant(std::int64_t value) { return QVariant::fromValue<qlonglong>(value); }
    static QVariant variant(int value) { return value; }
    static QVariant variant(double value) { return value; }
    static QVariant variant(std::string_view utf8);
    static QVariant variant(const std::string& utf8) { return variant(std::string_view(utf8)); }
    static QVariant variant(SqlBytes value);
    template <typename T>
    static QVariant variant(const std::optional<T>& value) {
        return value ? variant(*value) : QVariant();
    }

    QString name_;
    QSqlDatabase database_;
    std::unordered_map<const char*, std::unique_ptr<QSqlQuery>> queries_;
    std::int64_t last_id_ = 0;
    MemoryTurn turn_; ///< none for a file
    int runs_ = 0;    ///< that are not ended
    bool writes_ = false;
};

/// All or nothing: undone unless committed. Other writers wait from its first moment.
class SqlTransaction {
public:
    explicit SqlTransaction(SqlConnection& connection);
    SqlTransaction(const SqlTransaction&) = delete;
    SqlTransaction& operator=(const SqlTransaction&) = delete;
    ~SqlTransaction();
    void commit();

private:
    void end();

    SqlConnection& connection_;
    bool open_ = true;
};

} // namespace tp
