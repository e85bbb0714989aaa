#include "verify/campaign/database.h"

#include "tetracone/covering/io/input_error.h"

#include <sqlite3.h>

#include <cctype>
#include <chrono>
#include <thread>

namespace tetracone::verify {

namespace {

constexpr std::chrono::seconds longest_wait{60};

/// The file as an SQLite URI that takes no lock and needs no files beside it. This is right only if nobody can write
/// the file.
std::string immutable(const std::filesystem::path& file)
{
  constexpr std::string_view hex = "0123456789abcdef";
  std::string uri = "file:";
  for (const unsigned char c : file.native()) {
    if (std::isalnum(c) || c == '/' || c == '.')
      uri += char(c);
    else
      uri += {'%', hex[c / 16], hex[c % 16]};
  }
  return uri + "?immutable=1";
}

int execute(sqlite3* database, const char* sql) { return sqlite3_exec(database, sql, nullptr, nullptr, nullptr); }

}  // namespace

Database::Database(const std::filesystem::path& file, Mode mode) : file_(file)
{
  if (mode == Mode::read) {
    open(file.native(), SQLITE_OPEN_READONLY);
    // A write-ahead database needs files beside it even for reading. If they do not exist, nobody is writing it.
    const int status = execute(database_.get(), "SELECT 1 FROM sqlite_master");
    if ((status == SQLITE_CANTOPEN || status == SQLITE_READONLY) && !std::filesystem::exists(file.native() + "-wal"))
      open(immutable(file), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
    return;
  }
  open(file.native(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  // SQLite itself does not wait for this lock.
  const auto start = std::chrono::steady_clock::now();
  while (execute(database_.get(), "PRAGMA journal_mode = WAL") == SQLITE_BUSY &&
         std::chrono::steady_clock::now() - start < longest_wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
}

void Database::open(const std::string& name, int flags)
{
  sqlite3* handle = nullptr;
  const int status = sqlite3_open_v2(name.c_str(), &handle, flags, nullptr);
  database_.reset(handle);
  if (status != SQLITE_OK)
    throw covering::Input_error(file_.native(), 0, "cannot be opened",
                                "expected a database that `tetracone verify` wrote");
  sqlite3_busy_timeout(handle, int(std::chrono::milliseconds(longest_wait).count()));
}

Database::~Database() = default;

void Database::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

void Database::refuse() const
{
  throw covering::Input_error(file_.native(), 0, sqlite3_errmsg(database_.get()),
                              "expected a database that `tetracone verify` wrote");
}

void Database::run(const std::string& sql)
{
  if (execute(database_.get(), sql.c_str()) != SQLITE_OK) refuse();
}

Database::Transaction::~Transaction()
{
  if (open_) execute(database_.database_.get(), "ROLLBACK");
}

void Database::Transaction::commit()
{
  database_.run("COMMIT");
  open_ = false;
}

Database::Statement::Statement(Database& database, std::string_view sql) : database_(database)
{
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database.database_.get(), sql.data(), int(sql.size()), &statement, nullptr) != SQLITE_OK)
    database.refuse();
  statement_.reset(statement);
}

void Database::Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

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
  if (sqlite3_bind_text(statement_.get(), index, value.data(), int(value.size()), SQLITE_TRANSIENT) != SQLITE_OK)
    database_.refuse();
}

}  // namespace tetracone::verify
