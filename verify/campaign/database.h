#ifndef TETRACONE_VERIFY_CAMPAIGN_DATABASE_H
#define TETRACONE_VERIFY_CAMPAIGN_DATABASE_H

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace tetracone::verify {

/// An SQLite file. Not thread-safe. Every member throws covering::Input_error, with the file's name, when SQLite
/// refuses.
class Database {
 public:
  enum class Mode { read, write };

  /// Opens the file. `Mode::write` creates it if needed, in write-ahead mode, so that a killed process leaves only
  /// whole transactions. It waits for another process that does so too. `Mode::read` needs only the file itself. Throws
  /// also when the file is no database.
  Database(const std::filesystem::path& file, Mode mode);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  const std::filesystem::path& file() const { return file_; }

  /// Runs one or more statements that return nothing.
  void run(const std::string& sql);

  /// A transaction: rolled back at its end unless committed.
  class Transaction {
   public:
    explicit Transaction(Database& database) : database_(database) { database_.run("BEGIN IMMEDIATE"); }
    ~Transaction();
    void commit();

   private:
    Database& database_;
    bool open_ = true;
  };

  /// A prepared statement; its parameters are ?1, ?2, ... in order.
  class Statement {
   public:
    Statement(Database& database, std::string_view sql);

    /// Runs from the start with these parameters; `next` then fetches the rows, for a statement that has any.
    template <class... Values>
    Statement& with(const Values&... values)
    {
      reset();
      int index = 0;
      (bind(++index, values), ...);
      return *this;
    }

    /// Goes to the next row; false when there is none left.
    bool next();

    /// `with` for a statement without rows.
    template <class... Values>
    void run(const Values&... values)
    {
      with(values...).next();
      reset();
    }

    int columns() const;
    std::string name(int column) const;
    std::int64_t integer(int column) const;
    double real(int column) const;
    std::string text(int column) const;

   private:
    void reset();
    void bind(int index, std::int64_t value);
    void bind(int index, int value) { bind(index, std::int64_t(value)); }
    void bind(int index, std::uint64_t value) { bind(index, std::int64_t(value)); }
    void bind(int index, bool value) { bind(index, std::int64_t(value)); }
    void bind(int index, double value);
    void bind(int index, std::string_view value);
    void bind(int index, const std::string& value) { bind(index, std::string_view(value)); }
    void bind(int index, const char* value) { bind(index, std::string_view(value)); }

    struct Finalize {
      void operator()(sqlite3_stmt* statement) const;
    };
    Database& database_;
    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  };

 private:
  friend class Statement;
  void open(const std::string& name, int flags);
  [[noreturn]] void refuse() const;

  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::filesystem::path file_;
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace tetracone::verify

#endif
