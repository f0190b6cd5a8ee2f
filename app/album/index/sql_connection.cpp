// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/sql_connection.hpp"

#include "core/files/file_name.hpp"
#include "core/files/open_file.hpp"

#include <QSqlError>
#include <QString>

#include <atomic>
#include <utility>

namespace tp {

namespace {

// https://www.sqlite.org/rescode.html
constexpr int sqlite_corrupt = 11, sqlite_full = 13, sqlite_cannot_open = 14, sqlite_not_a_database = 26;

[[noreturn]] void fail(const QSqlError& error) {
    throw SqlFault{error.nativeErrorCode().toInt() & 0xFF, error.databaseText().toStdString()};
}

QString unused_name() {
    static std::atomic<int> count = 0;
    return QStringLiteral("tp_index_%1").arg(++count);
}

} // namespace

bool SqlFault::damaged() const { return code == sqlite_corrupt || code == sqlite_not_a_database; }

bool SqlFault::full() const { return code == sqlite_full; }

SqlRun::SqlRun(QSqlQuery& query, SqlConnection& connection) : query_(&query), connection_(&connection) {
    connection.begin_run();
}

SqlRun::~SqlRun() {
    if (!query_)
        return;
    query_->finish();
    connection_->end_run();
}

bool SqlRun::next() {
    if (query_->next())
        return true;
    if (query_->lastError().isValid())
        fail(query_->lastError());
    return false;
}

std::int64_t SqlRun::integer(int column) const { return query_->value(column).toLongLong(); }
double SqlRun::real(int column) const { return query_->value(column).toDouble(); }
std::string SqlRun::text(int column) const { return query_->value(column).toString().toStdString(); }
std::string SqlRun::bytes(int column) const { return query_->value(column).toByteArray().toStdString(); }
bool SqlRun::null(int column) const { return query_->isNull(column); }

SqlConnection SqlConnection::to_file(const std::filesystem::path& file) {
    // made here, because SQLite would let the umask say who may read it; its -wal and -shm follow the file
    if (!OpenFile(file, {.write = true, .make = true, .follow_link = false, .readers = Readers::owner_only})
             .ok())
        throw SqlFault{sqlite_cannot_open, "unable to open database file"};
    return {QString::fromStdString(name_in_utf8(file)), QStringLiteral("QSQLITE_BUSY_TIMEOUT=20000"),
            nullptr};
}

SqlConnection SqlConnection::to_memory(const std::string& name, const MemoryTurn& turn) {
    return {QStringLiteral("file:%1?mode=memory&cache=shared").arg(QString::fromStdString(name)),
            QStringLiteral("QSQLITE_OPEN_URI"), turn};
}

SqlConnection::SqlConnection(const QString& path, const QString& options, MemoryTurn turn)
    : name_(unused_name()), database_(QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), name_)),
      turn_(std::move(turn)) {
    database_.setDatabaseName(path);
    database_.setConnectOptions(options);
    try {
        if (!database_.open())
            fail(database_.lastError());
        run_once("PRAGMA foreign_keys = ON");
        if (!turn_)
            run_once("PRAGMA journal_mode = WAL");
        run_once("PRAGMA synchronous = NORMAL"); // a power cut may take the last batch, never more
        run_once("PRAGMA secure_delete = ON");   // what is deleted is overwritten
        run_once("PRAGMA temp_store = MEMORY");
        run_once("PRAGMA cache_size = -16000");
    } catch (const SqlFault&) {
        database_ = QSqlDatabase();
        QSqlDatabase::removeDatabase(name_);
        throw;
    }
}

SqlConnection::SqlConnection(SqlConnection&& other) noexcept
    : name_(std::exchange(other.name_, QString())), database_(std::exchange(other.database_, QSqlDatabase())),
      queries_(std::move(other.queries_)), last_id_(other.last_id_), turn_(std::move(other.turn_)) {}

SqlConnection::~SqlConnection() {
    if (name_.isEmpty())
        return;
    queries_.clear();
    database_ = QSqlDatabase();
    QSqlDatabase::removeDatabase(name_);
}

void SqlConnection::begin_run() {
    if (runs_++ == 0 && turn_ && !writes_)
        turn_->lock_shared();
}

void SqlConnection::end_run() {
    if (--runs_ == 0 && turn_ && !writes_)
        turn_->unlock_shared();
}

QSqlQuery& SqlConnection::prepared(const char* sql) {
    std::unique_ptr<QSqlQuery>& query = queries_[sql];
    if (!query) {
        auto made = std::make_unique<QSqlQuery>(database_);
        made->setForwardOnly(true);
        if (!made->prepare(QString::fromUtf8(sql)))
            fail(made->lastError());
        query = std::move(made);
    }
    return *query;
}

SqlRun SqlConnection::execute(QSqlQuery& query) {
    SqlRun run(query, *this);
    if (!query.exec())
        fail(query.lastError());
    if (!query.isSelect())
        last_id_ = query.lastInsertId().toLongLong();
    return run;
}

void SqlConnection::run_once(const std::string& sql) {
    QSqlQuery query(database_);
    query.setForwardOnly(true);
    const SqlRun run(query, *this);
    if (!query.exec(QString::fromStdString(sql)))
        fail(query.lastError());
}

QVariant SqlConnection::variant(std::string_view utf8) {
    return utf8.empty() ? QStringLiteral("")
                        : QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

QVariant SqlConnection::variant(SqlBytes value) {
    return value.bytes.empty() ? QByteArrayLiteral("")
                               : QByteArray(value.bytes.data(), static_cast<qsizetype>(value.bytes.size()));
}

SqlTransaction::SqlTransaction(SqlConnection& connection) : connection_(connection) {
    if (connection_.turn_)
        connection_.turn_->lock();
    connection_.writes_ = true;
    try {
        connection_.run("BEGIN IMMEDIATE");
    } catch (const SqlFault&) {
        end();
        throw;
    }
}

SqlTransaction::~SqlTransaction() {
    if (!open_)
        return;
    try {
        connection_.run("ROLLBACK");
    } catch (const SqlFault&) { // SQLite has undone it by itself already, as on a full disk
    }
    end();
}

void SqlTransaction::commit() {
    connection_.run("COMMIT");
    open_ = false;
    end();
}

void SqlTransaction::end() {
    connection_.writes_ = false;
    if (connection_.turn_)
        connection_.turn_->unlock();
}

} // namespace tp
