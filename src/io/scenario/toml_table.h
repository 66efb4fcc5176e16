// A TOML table whose values are checked when they are read. An Error names file, line and key.
//
// Wraps one toml++ table. Type and range of every value that is read are checked.
// refuseUnknownKeys() throws Error for keys that were never read, so that a misspelt key is not
// silently ignored.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/pose.h"
#include "operation/setting_ranges.h"

namespace toml {
inline namespace v3 {
class table;
class node;
}  // namespace v3
}  // namespace toml

namespace resect {

class TomlTable {
 public:
  static TomlTable readFile(const std::filesystem::path& path);
  // name: stands for the file in Errors.
  static TomlTable parse(const std::string& text, const std::string& name);

  bool has(const std::string& key) const;
  // low, high: the least and the greatest value allowed. If the key is missing, the result is
  // `missing`. If `missing` is not given either, throws Error.
  double number(const std::string& key, double low, double high,
                std::optional<double> missing = {}) const;
  double number(const std::string& key, const SettingRange& range,
                std::optional<double> missing = {}) const {
    return number(key, range.low, range.high, missing);
  }
  int integer(const std::string& key, int low, int high, std::optional<int> missing = {}) const;
  // text(): a name or a title, which must not be empty. freeText(): a text that may be empty.
  std::string text(const std::string& key, std::optional<std::string> missing = {}) const;
  std::string freeText(const std::string& key) const;  // empty if the key is missing
  bool flag(const std::string& key, bool missing) const;
  Vec3 vec3(const std::string& key, std::optional<Vec3> missing = {}) const;
  // Does the same as vec3() for a position. Each coordinate must be at most `farthest` m away from
  // 0.
  Vec3 place(const std::string& key, double farthest, std::optional<Vec3> missing = {}) const;
  // A list of numbers, [1, 2, ...], each from `low` to `high`. Empty if the key is missing.
  std::vector<double> numbers(const std::string& key, double low, double high) const;
  // A list of points, [[x, y, z], ...]. Each coordinate must be at most `farthest` away from 0.
  // Empty if the key is missing.
  std::vector<Vec3> points(const std::string& key, double farthest = 1e6) const;
  // A list of texts, ["a", "b", ...], none of which may be empty. Empty if the key is missing.
  std::vector<std::string> texts(const std::string& key) const;
  // A length, m, given as "5mm" or as a number of metres.
  double length(const std::string& key, double low, double high) const;
  // A rotation. It is given as { axis = [x, y, z], degrees = 30 }, or for a tool as
  // { handle = [x, y, z], edge = [x, y, z] }. The second form gives two directions in the world:
  // `handle` for +Z of the tool's frame, and `edge` for -Y. Identity if the key is missing.
  Eigen::Quaterniond rotation(const std::string& key) const;

  std::optional<TomlTable> table(const std::string& key) const;
  bool isList(const std::string& key) const;
  bool isText(const std::string& key) const;
  bool isTable(const std::string& key) const;
  // The tables of [[key]] or of key = [{...}, ...], at most `most`. A single table [key] gives a
  // list with one element. The list is empty if the key is missing.
  std::vector<TomlTable> tables(const std::string& key, std::size_t most = 1000) const;

  std::vector<std::string> keys() const;  // of this table, not of tables in it; sorted
  std::string asText() const;             // this table as a TOML document, without comments

  // A copy of this table in which the key at `path`, such as "level" or "organ[0].spacing", has the
  // value `value`, which is TOML text. If `value` is empty, the copy lacks the key. Throws Error if
  // the path does not exist, or if `value` is not a TOML value.
  TomlTable with(const std::string& path, const std::string& value) const;

  // Throws Error if this table has a key that was not read. Does not look into tables inside this
  // one.
  void refuseUnknownKeys() const;
  // Throws an Error that gives file, line and key, then the sentence.
  [[noreturn]] void complain(const std::string& key, const std::string& sentence) const;
  const std::string& file() const { return file_; }

 private:
  TomlTable(std::shared_ptr<const toml::table> root, const toml::table* table, std::string file,
            std::string path);
  const toml::node* find(const std::string& key) const;
  std::string where(const toml::node* node) const;
  Vec3 toVec3(const toml::node& node, const std::string& key, double farthest = 1e6) const;
  std::string toText(const toml::node& node, const std::string& key) const;

  std::shared_ptr<const toml::table> root_;  // keeps the document alive
  const toml::table* table_;
  std::string file_, path_;
  std::shared_ptr<std::set<std::string>> asked_;  // keys that were read
};

}  // namespace resect
