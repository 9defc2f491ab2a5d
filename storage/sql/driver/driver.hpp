#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace floeplan::sql {

/// Identifies the state that a connection sees: the same version means the same data. Versions of two
/// connections cannot be compared. The meaning of the numbers depends on the driver.
struct Version {
  std::array<std::uint32_t, 12> numbers{};

  friend bool operator==(const Version&, const Version&) = default;
};

/// Whether other transactions may write to the store while a writing transaction lasts. A transaction `beside_others`
/// must write nothing whose order among other writes matters. An embedded engine always lets one write at a time.
enum class WriteTurn { alone, beside_others };

enum class ColumnType { integer, real, text, blob };

/// A statement that an engine has parsed. `Statement` is what callers use.
/// Edges    parameters count from 1, columns from 0; values are copied when bound; a blob is valid until the next step
/// Errors   Failure when the engine refuses
class PreparedStatement {
 public:
  virtual ~PreparedStatement() = default;

  virtual void bind(int parameter, const std::string& value) = 0;
  virtual void bind(int parameter, std::int64_t value) = 0;
  virtual void bind(int parameter, double value) = 0;
  virtual void bind(int parameter, std::span<const std::byte> value) = 0;
  /// NULL where a value of this type might be.
  virtual void bind_null(int parameter, ColumnType type) = 0;

  /// Moves to the next row. False: there is none.
  [[nodiscard]] virtual bool step() = 0;
  /// Runs the statement to its end and resets it. Returns the number of changed rows.
  virtual int run() = 0;
  /// Resets the statement, so that it can be bound and run again.
  virtual void reset() = 0;

  [[nodiscard]] virtual bool is_null(int column) const = 0;
  [[nodiscard]] virtual std::string text(int column) const = 0;
  [[nodiscard]] virtual std::int64_t integer(int column) const = 0;
  [[nodiscard]] virtual double real(int column) const = 0;
  [[nodiscard]] virtual std::span<const std::byte> blob(int column) const = 0;
};

/// Which kind of engine keeps a database: a library inside this program, in files of the store's folder, or a server that
/// many machines use.
enum class Engine { embedded, server };

/// The notices of other connections.
struct Announced {
  std::vector<std::string> texts;  // oldest first
  bool missed{false};              // the connection was lost for a while, and more may have been announced
};

/// One connection to a database engine: the operations in which engines differ. Operations with the same text
/// for all engines (COMMIT, ROLLBACK, savepoints) are run as scripts.
/// Threads  one thread at a time
/// Errors   Failure when the engine refuses
class Driver {
 public:
  virtual ~Driver() = default;

  [[nodiscard]] virtual Engine engine() const = 0;
  /// A statement without values, perhaps one that was parsed before. It must be destroyed before the driver.
  [[nodiscard]] virtual std::unique_ptr<PreparedStatement> prepare(const std::string& sql) = 0;
  virtual void run_script(const std::string& script) = 0;

  [[nodiscard]] virtual bool is_in_transaction() = 0;
  /// Begins a transaction with the right to write, which it waits for.
  virtual void begin_writing(WriteTurn turn) = 0;
  /// Commits the transaction.
  /// Errors  Failure also if the transaction was undone before, so that no lost change is acknowledged
  virtual void commit() = 0;
  /// Rolls the transaction back, also one that has failed or was lost.
  virtual void roll_back() = 0;
  /// Begins a transaction that reads as of its first read, and waits for nobody.
  virtual void begin_reading() = 0;
  /// A value that changes with every commit of any connection. Cheap.
  [[nodiscard]] virtual Version version() = 0;

  /// Seconds since 1970 by the clock that all connections share.
  [[nodiscard]] virtual double time_s() = 0;
  /// Runs a statement without values, and again whenever a new session takes the place of one that was lost.
  virtual void in_each_session(const std::string& statement) = 0;
  /// Waits until something is announced, at most this long.
  [[nodiscard]] virtual Announced announced(std::chrono::milliseconds at_most) = 0;

  /// Writes the whole database in its present state to a new file.
  virtual void back_up(const std::filesystem::path& file) = 0;
  /// Whether the pages of the database have checksums.
  [[nodiscard]] virtual bool has_page_checksums() = 0;
  /// Numbers of the pages, from 1, whose bytes in the file have changed.
  [[nodiscard]] virtual std::vector<std::uint32_t> damaged_pages() = 0;
};

}  // namespace floeplan::sql
