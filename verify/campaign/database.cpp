#include "verify/campaign/database.h"

#include "tetracone/covering/io/input_error.h"

#include <sqlite3.h>

namespace tetracone::verify {

Database::Database(const std::filesystem::path& file, Mode mode) : file_(file)
{
  sqlite3* handle = nullptr;
  const int flags = mode == Mode::write ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY;
  const int status = sqlite3_open_v2(file.c_str(), &handle, flags, nullptr);
  database_.reset(handle);
  if (status != SQLITE_OK) throw covering::Input_error(file_.native(), 0, "cannot be opened", "expected a database that `tetracone verify` wrote");
  sqlite3_busy_timeout(handle, 60'000);
  if (mode == Mode::write) run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
}

Database::~Database() = default;

void Database::Close::operator()(sqlite3* database) const
{
  sqlite3_close_v2(database);
}

void Database::refuse() const
{
  throw covering::Input_error(file_.native(), 0, sqlite3_errmsg(database_.get()), "expected a database that `tetracone verify` wrote");
}

void Database::run(const std::string& sql)
{
  if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) refuse();
}

Database::Transaction::~Transaction()
{
  if (open_) sqlite3_exec(database_.database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Database::Transaction::commit()
{
  database_.run("COMMIT");
  open_ = false;
}

Database::Statement::Statement(Database& database, std::string_view sql) : database_(database)
{
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database.database_.get(), sql.data(), int(sql.size()), &statement, nullptr) != SQLITE_OK) database.refuse();
  statement_.reset(statement);
}

void Database::Statement::Finalize::operator()(sqlite3_stmt* statement) const
{
  sqlite3_finalize(statement);
}

bool Database::Statement::next()
{
  const int status = sqlite3_step(statement_.get());
  if (status != SQLITE_ROW && status != SQLITE_DONE) database_.refuse();
  return status == SQLITE_ROW;
}

int Database::Statement::columns() const { return sqlite3_column_count(statement_.get()); }
std::string Database::Statement::name(int column) const { return sqlite3_column_name(statement_.get(), column); }
std::int64_t Database::Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
double Database::Statement::real(int column) const { return sqlite3_column_double(statement_.get(), column); }

std::string Database::Statement::text(int column) const
{
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return text == nullptr ? "" : text;
}

void Database::Statement::reset() { sqlite3_reset(statement_.get()); }

void Database::Statement::bind(int index, std::int64_t value)
{
  if (sqlite3_bind_int64(statement_.get(), index, value) != SQLITE_OK) database_.refuse();
}

void Database::Statement::bind(int index, double value)
{
  if (sqlite3_bind_double(statement_.get(), index, value) != SQLITE_OK) database_.refuse();
}

void Database::Statement::bind(int index, std::string_view value)
{
  if (sqlite3_bind_text(statement_.get(), index, value.data(), int(value.size()), SQLITE_TRANSIENT) != SQLITE_OK) database_.refuse();
}

}  // namespace tetracone::verify
