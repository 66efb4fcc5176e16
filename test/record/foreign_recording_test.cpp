// Databases of others: what arrives of them, and what an answer of their reader cannot do.
#include "record/file/foreign_recording.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "base/random.h"
#include "record/file/recording_file.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

Database empty() {
  Database own = Database::inMemory("here");
  makeRecordingTables(own);
  return own;
}

constexpr const char* kRows =
    "INSERT INTO meta VALUES ('program', 'test');"
    "INSERT INTO branch VALUES (0, -1, 0, 'first'), (1, 0, 20, 'undo 1');"
    "INSERT INTO frames VALUES (0, 1, 0.25, 1, x'0102', x'0304'), (0, 2, 0.5, 0, x'', x'05');"
    "INSERT INTO samples VALUES (0, 1, 0, 1.5, 2.5, NULL, -0.0, 1e300, 0.1);";

// The answer of the reader for a recording with these rows.
std::string answer() {
  Database own = empty();
  own.run(kRows);
  const RecordingShape shape = shapeOf(own);
  std::string rows(8, '\0');  // nothing was found
  for (const RecordingShape::Table& table : shape.tables) {
    Statement all(own, "SELECT * FROM " + table.name);
    while (all.step()) {
      rows += char(1);
      appendRow(rows, all);
    }
    rows += char(0);
  }
  return rows;
}

// What arrives, as an answer again.
std::string arrived(Database& own) {
  std::string rows;
  for (const RecordingShape::Table& table : shapeOf(own).tables) {
    Statement all(own, "SELECT * FROM " + table.name);
    while (all.step()) appendRow(rows, all);
  }
  return rows;
}

}  // namespace

TEST_CASE("rows arrive as they are, out of a file and its log") {
  const test::TemporaryFolder folder;
  Database wanted = empty();
  wanted.run(kRows);
  const auto path = folder / "a.resect";
  Database writing(path, path.string());
  writing.run("PRAGMA journal_mode = WAL; PRAGMA wal_autocheckpoint = 0");
  makeRecordingTables(writing);
  writing.run(kRows);  // they are in the log only
  REQUIRE(std::filesystem::file_size(path.string() + "-wal") > 4096);
  const std::string file = test::bytesOf(path), log = test::bytesOf(path.string() + "-wal");
  Database own = empty();
  CHECK(addForeignRows(path, own) == "");
  CHECK(arrived(own) == arrived(wanted));
  CHECK(test::bytesOf(path) == file);
  CHECK(test::bytesOf(path.string() + "-wal") == log);
}

TEST_CASE("an answer that is cut off or changed is refused in a sentence, or gives other values") {
  const std::string rows = answer();
  Database own = empty();
  const RecordingShape shape = shapeOf(own);
  CHECK(addRows(rows, shape, own) == "");
  for (std::size_t cut = 0; cut < rows.size(); ++cut) {
    Database to = empty();
    CHECK(test::isOneSentence(
        test::sentenceOf([&] { addRows(std::string_view(rows).substr(0, cut), shape, to); })));
  }
  Database more = empty();
  CHECK_THROWS_AS(addRows(rows + '\0', shape, more), Error);
  Random random(1);
  int refused = 0;
  for (int i = 0; i < 500; ++i) {
    std::string changed = rows;
    char& byte = changed[std::size_t(random.below(int(rows.size())))];
    byte = char(byte ^ (1 << random.below(8)));
    Database to = empty();
    try {
      addRows(changed, shape, to);
    } catch (const Error& e) {
      ++refused;
      CHECK(test::isOneSentence(e.what()));
    }
  }
  CHECK(refused > 100);
}

TEST_CASE("an answer with a value of another type than its column is refused") {
  const test::TemporaryFolder folder;
  for (const char* row : {"INSERT INTO branch VALUES (0, 'x', 0, 'first')",
                          "INSERT INTO frames VALUES (0, 1, 'x', 1, x'', x'')",
                          "INSERT INTO frames VALUES (0, 1, 0.5, 1, 'text', x'')",
                          "INSERT INTO scenario VALUES (x'00', '', '', x'')"}) {
    CAPTURE(row);
    const auto path = folder / (std::to_string(std::hash<std::string>()(row)) + ".resect");
    {
      Database other(path, path.string());
      makeRecordingTables(other);
      other.run(row);
    }
    Database own = empty();
    CHECK(test::refuses([&] { addForeignRows(path, own); }, "a value that a recording has not"));
  }
}

TEST_CASE("a state that is no zstd, or of another size than its row says, is refused") {
  const Bytes nothing(100, std::byte(7));
  for (const std::int64_t size : {std::int64_t(-1), std::int64_t(0), std::int64_t(1000),
                                  std::int64_t(1) << 31, std::int64_t(1) << 62})
    CHECK(test::refuses([&] { unpackForeign(nothing, size, "f"); }, "f: a key state in it"));
}
